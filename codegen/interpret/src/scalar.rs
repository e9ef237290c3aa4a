//! Operations on one-word values, exactly as in Rust (or in the DSL, where Rust leaves bits open).
//!
//! Invariants: operands and results are canonical words of their types; a float operation rounds once, in its own
//! type; no operations are fused.
//!
//! Must not know: control flow, memory, spans. A fault is returned without its place.

use bessemer_ir::{BinaryOp, CompareOp, Fault, Float, Int, Intrinsic, Scalar, Type, UnaryOp};

/// Returns the word of `value`, reduced to the width of `int`.
fn wrap(int: Int, value: i128) -> u64 {
    let unused = 64 - int.bits();
    let high = (value as u64) << unused;
    if int.signed() { ((high as i64) >> unused) as u64 } else { high >> unused }
}

/// Returns the word of `value`, or an overflow fault.
fn checked(int: Int, value: Option<i128>) -> Result<u64, Fault> {
    match value {
        Some(value) if int.min() <= value && value <= int.max() => Ok(value as u64),
        _ => Err(Fault::Overflow),
    }
}

fn f32_of(word: u64) -> f32 {
    f32::from_bits(word as u32)
}

fn f32_word(value: f32) -> u64 {
    u64::from(value.to_bits())
}

pub(super) fn unary(op: UnaryOp, ty: &Type, word: u64) -> Result<u64, Fault> {
    match (op, ty) {
        (UnaryOp::Neg, Type::Scalar(Scalar::Float(Float::F64))) => {
            Ok((-f64::from_bits(word)).to_bits())
        }
        (UnaryOp::Neg, Type::Scalar(Scalar::Float(Float::F32))) => Ok(f32_word(-f32_of(word))),
        (UnaryOp::Neg, Type::Scalar(Scalar::Int(int))) => checked(*int, Some(-int.from_word(word))),
        (UnaryOp::Not, Type::Scalar(Scalar::Bool)) => Ok(word ^ 1),
        (UnaryOp::Not, Type::Scalar(Scalar::Int(int))) => Ok(wrap(*int, i128::from(!word))),
        _ => unreachable!("validated: `-` takes numbers, `!` takes bool and integers"),
    }
}

/// Computes a binary operation on operands of type `ty`; only the right operand of a shift may have another type.
pub(super) fn binary(
    op: BinaryOp,
    ty: &Type,
    left: u64,
    right_type: &Type,
    right: u64,
) -> Result<u64, Fault> {
    match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => {
            let value = float(op, f64::from_bits(left), f64::from_bits(right));
            Ok(value.to_bits())
        }
        Type::Scalar(Scalar::Float(Float::F32)) => {
            Ok(f32_word(float(op, f32_of(left), f32_of(right))))
        }
        Type::Scalar(Scalar::Int(int)) => integer(op, *int, left, right_type, right),
        _ => Ok(bitwise(op, left, right)),
    }
}

fn float<F>(op: BinaryOp, left: F, right: F) -> F
where
    F: core::ops::Add<Output = F>
        + core::ops::Sub<Output = F>
        + core::ops::Mul<Output = F>
        + core::ops::Div<Output = F>
        + core::ops::Rem<Output = F>,
{
    match op {
        BinaryOp::Add => left + right,
        BinaryOp::Sub => left - right,
        BinaryOp::Mul => left * right,
        BinaryOp::Div => left / right,
        BinaryOp::Rem => left % right,
        _ => unreachable!("validated: floats have no bitwise operators"),
    }
}

/// Computes a bit operation on canonical words; bits beyond the width equal the sign bit, so the result is canonical.
fn bitwise(op: BinaryOp, left: u64, right: u64) -> u64 {
    match op {
        BinaryOp::And => left & right,
        BinaryOp::Or => left | right,
        BinaryOp::Xor => left ^ right,
        _ => unreachable!("validated: bool has only bitwise operators"),
    }
}

fn integer(op: BinaryOp, int: Int, a: u64, right_type: &Type, b: u64) -> Result<u64, Fault> {
    let (left, right) = (int.from_word(a), int.from_word(b));
    match op {
        BinaryOp::Add => checked(int, left.checked_add(right)),
        BinaryOp::Sub => checked(int, left.checked_sub(right)),
        BinaryOp::Mul => checked(int, left.checked_mul(right)),
        BinaryOp::Div | BinaryOp::Rem if right == 0 => Err(Fault::DivisionByZero),
        BinaryOp::Div => checked(int, left.checked_div(right)),
        // `MIN % -1` faults although its value would be 0: Rust computes it beside the quotient.
        BinaryOp::Rem => checked(int, left.checked_div(right)).map(|_| (left % right) as u64),
        BinaryOp::And | BinaryOp::Or | BinaryOp::Xor => Ok(bitwise(op, a, b)),
        BinaryOp::Shl | BinaryOp::Shr => {
            let Some(amount_type) = right_type.as_int() else {
                unreachable!("validated: a shift's right side is an integer")
            };
            let amount = amount_type.from_word(b);
            if amount < 0 || amount >= i128::from(int.bits()) {
                return Err(Fault::Shift);
            }
            let shifted = if op == BinaryOp::Shl { left << amount } else { left >> amount };
            Ok(wrap(int, shifted))
        }
    }
}

pub(super) fn compare(op: CompareOp, ty: &Type, left: u64, right: u64) -> bool {
    match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => {
            ordered(op, f64::from_bits(left), f64::from_bits(right))
        }
        Type::Scalar(Scalar::Float(Float::F32)) => ordered(op, f32_of(left), f32_of(right)),
        Type::Scalar(Scalar::Int(int)) => ordered(op, int.from_word(left), int.from_word(right)),
        _ => ordered(op, left, right),
    }
}

fn ordered<T: PartialOrd>(op: CompareOp, left: T, right: T) -> bool {
    match op {
        CompareOp::Eq => left == right,
        CompareOp::Ne => left != right,
        CompareOp::Lt => left < right,
        CompareOp::Le => left <= right,
        CompareOp::Gt => left > right,
        CompareOp::Ge => left >= right,
    }
}

/// Converts as Rust's `as` does.
pub(super) fn cast(from: &Type, to: &Type, word: u64) -> u64 {
    let Type::Scalar(to) = to else { unreachable!("validated: `as` gives a scalar") };
    match from {
        Type::Scalar(Scalar::Float(Float::F64)) => cast_float(f64::from_bits(word), *to),
        // Exact, so that what follows rounds once; f32 to f32 keeps its value.
        Type::Scalar(Scalar::Float(Float::F32)) => cast_float(f64::from(f32_of(word)), *to),
        Type::Scalar(Scalar::Int(int)) => cast_int(int.from_word(word), *to),
        _ => cast_int(i128::from(word), *to),
    }
}

/// Converts an integer to type `to`, as Rust's `as` does.
pub(super) fn cast_number(value: i128, to: &Type) -> u64 {
    let Type::Scalar(to) = to else { unreachable!("validated: `as` gives a scalar") };
    cast_int(value, *to)
}

fn cast_float(value: f64, to: Scalar) -> u64 {
    match to {
        Scalar::Float(Float::F64) => value.to_bits(),
        Scalar::Float(Float::F32) => f32_word(value as f32),
        // Towards zero, NaN to 0; then to the nearest end of the range.
        Scalar::Int(int) => (value as i128).clamp(int.min(), int.max()) as u64,
        Scalar::Bool => unreachable!("validated: nothing but bool casts to bool"),
    }
}

fn cast_int(value: i128, to: Scalar) -> u64 {
    match to {
        Scalar::Float(Float::F64) => (value as f64).to_bits(),
        Scalar::Float(Float::F32) => f32_word(value as f32),
        Scalar::Int(int) => wrap(int, value),
        Scalar::Bool => value as u64,
    }
}

/// Computes an intrinsic; `ty` is the type of its first operand.
pub(super) fn intrinsic(function: Intrinsic, ty: &Type, operands: &[u64]) -> Result<u64, Fault> {
    let at = |index: usize| operands[index];
    match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => {
            let value = |index: usize| f64::from_bits(at(index));
            Ok(match function {
                Intrinsic::Sqrt => value(0).sqrt().to_bits(),
                Intrinsic::Abs => value(0).abs().to_bits(),
                Intrinsic::Floor => value(0).floor().to_bits(),
                Intrinsic::Min => smaller(value(0), value(1), f64::is_sign_negative).to_bits(),
                Intrinsic::Max => larger(value(0), value(1), f64::is_sign_negative).to_bits(),
                Intrinsic::Clamp => clamp(value(0), value(1), value(2))?.to_bits(),
                Intrinsic::ToBits if value(0).is_nan() => 0x7ff8_0000_0000_0000,
                Intrinsic::ToBits | Intrinsic::RawBits => at(0),
                Intrinsic::Copysign if value(1).is_nan() => value(0).abs().to_bits(),
                Intrinsic::Copysign => value(0).copysign(value(1)).to_bits(),
                Intrinsic::Ceil => value(0).ceil().to_bits(),
                Intrinsic::Trunc => value(0).trunc().to_bits(),
                Intrinsic::Round => value(0).round().to_bits(),
                Intrinsic::Signum => value(0).signum().to_bits(),
                Intrinsic::DivEuclid => value(0).div_euclid(value(1)).to_bits(),
                Intrinsic::RemEuclid => value(0).rem_euclid(value(1)).to_bits(),
                Intrinsic::IsNan => u64::from(value(0).is_nan()),
                Intrinsic::IsFinite => u64::from(value(0).is_finite()),
                Intrinsic::IsInfinite => u64::from(value(0).is_infinite()),
                _ => unreachable!("validated: not a function of f64"),
            })
        }
        Type::Scalar(Scalar::Float(Float::F32)) => {
            let value = |index: usize| f32_of(at(index));
            Ok(match function {
                Intrinsic::Sqrt => f32_word(value(0).sqrt()),
                Intrinsic::Abs => f32_word(value(0).abs()),
                Intrinsic::Floor => f32_word(value(0).floor()),
                Intrinsic::Min => f32_word(smaller(value(0), value(1), f32::is_sign_negative)),
                Intrinsic::Max => f32_word(larger(value(0), value(1), f32::is_sign_negative)),
                Intrinsic::Clamp => f32_word(clamp(value(0), value(1), value(2))?),
                Intrinsic::ToBits if value(0).is_nan() => 0x7fc0_0000,
                Intrinsic::ToBits | Intrinsic::RawBits => at(0),
                Intrinsic::Copysign if value(1).is_nan() => f32_word(value(0).abs()),
                Intrinsic::Copysign => f32_word(value(0).copysign(value(1))),
                Intrinsic::Ceil => f32_word(value(0).ceil()),
                Intrinsic::Trunc => f32_word(value(0).trunc()),
                Intrinsic::Round => f32_word(value(0).round()),
                Intrinsic::Signum => f32_word(value(0).signum()),
                Intrinsic::DivEuclid => f32_word(value(0).div_euclid(value(1))),
                Intrinsic::RemEuclid => f32_word(value(0).rem_euclid(value(1))),
                Intrinsic::IsNan => u64::from(value(0).is_nan()),
                Intrinsic::IsFinite => u64::from(value(0).is_finite()),
                Intrinsic::IsInfinite => u64::from(value(0).is_infinite()),
                _ => unreachable!("validated: not a function of f32"),
            })
        }
        Type::Scalar(Scalar::Int(int)) => {
            integer_intrinsic(function, *int, |index| int.from_word(at(index)))
        }
        _ => unreachable!("validated: intrinsics take numbers"),
    }
}

fn integer_intrinsic(
    function: Intrinsic,
    int: Int,
    value: impl Fn(usize) -> i128,
) -> Result<u64, Fault> {
    Ok(match function {
        Intrinsic::Abs => checked(int, Some(value(0).abs()))?,
        Intrinsic::Min => value(0).min(value(1)) as u64,
        Intrinsic::Max => value(0).max(value(1)) as u64,
        Intrinsic::Clamp => clamp(value(0), value(1), value(2))? as u64,
        Intrinsic::WrappingAdd => wrap(int, value(0) + value(1)),
        Intrinsic::WrappingSub => wrap(int, value(0) - value(1)),
        Intrinsic::WrappingMul => wrap(int, value(0).wrapping_mul(value(1))),
        Intrinsic::WrappingDiv => wrap(int, value(0) / divisor(value(1))?),
        Intrinsic::WrappingRem => wrap(int, value(0) % divisor(value(1))?),
        Intrinsic::SaturatingAdd => saturated(int, value(0) + value(1)),
        Intrinsic::SaturatingSub => saturated(int, value(0) - value(1)),
        Intrinsic::SaturatingMul => saturated(int, value(0).saturating_mul(value(1))),
        Intrinsic::DivEuclid => checked(int, value(0).checked_div_euclid(divisor(value(1))?))?,
        // As `MIN % -1`, a fault although its value would be 0.
        Intrinsic::RemEuclid => checked(int, value(0).checked_div(divisor(value(1))?))
            .map(|_| value(0).rem_euclid(value(1)) as u64)?,
        // Unsigned words, for all that the operands are signed.
        Intrinsic::UnsignedAbs => value(0).unsigned_abs() as u64,
        Intrinsic::AbsDiff => value(0).abs_diff(value(1)) as u64,
        // Of unsigned integers, whose words have zeros above.
        Intrinsic::CountOnes => u64::from(value(0).count_ones()),
        Intrinsic::LeadingZeros => u64::from((value(0) as u64).leading_zeros() - (64 - int.bits())),
        Intrinsic::TrailingZeros => u64::from(value(0).trailing_zeros().min(int.bits())),
        Intrinsic::SwapBytes => (value(0) as u64).swap_bytes() >> (64 - int.bits()),
        // A float's bits are its word.
        Intrinsic::FromBits => value(0) as u64,
        _ => unreachable!("validated: not a function of integers"),
    })
}

fn divisor(value: i128) -> Result<i128, Fault> {
    if value == 0 { Err(Fault::DivisionByZero) } else { Ok(value) }
}

fn saturated(int: Int, value: i128) -> u64 {
    value.clamp(int.min(), int.max()) as u64
}

/// Returns the smaller operand. A NaN is ignored, and −0 is smaller than 0.
#[allow(clippy::eq_op, reason = "only NaN differs from itself")]
fn smaller<F: PartialOrd + Copy>(a: F, b: F, negative: impl Fn(F) -> bool) -> F {
    if a != a || b < a || (a == b && negative(b)) { b } else { a }
}

/// Returns the larger operand. A NaN is ignored, and 0 is larger than −0.
#[allow(clippy::eq_op, reason = "only NaN differs from itself")]
fn larger<F: PartialOrd + Copy>(a: F, b: F, negative: impl Fn(F) -> bool) -> F {
    if a != a || b > a || (a == b && !negative(b)) { b } else { a }
}

fn clamp<T: PartialOrd>(value: T, low: T, high: T) -> Result<T, Fault> {
    // Written so that a NaN among the bounds is a fault as well.
    if low <= high {
        Ok(if value < low {
            low
        } else if value > high {
            high
        } else {
            value
        })
    } else {
        Err(Fault::Clamp)
    }
}
