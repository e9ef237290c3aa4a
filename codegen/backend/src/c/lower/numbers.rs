//! Operators, conversions and functions of numbers.

use bessemer_ir::{BinaryOp, Expr as Ir, ExprKind, Float, Int, Intrinsic, Mode, Scalar, Type};

use super::super::helpers::{Helper, unsigned, unsigned_type};
use super::super::literal;
use super::super::spelling::scalar_type;
use super::super::tree::Expr;
use super::Lower;
use super::bits::{converted_once, counted, fits, is_bits, uncast};
use super::place::is_small;
use super::word::narrowed;

impl Lower<'_> {
    /// Returns `a op b` for two values of type `ty`; not for shifts, nor for `^` of two `bool`s, which is a
    /// comparison.
    pub(super) fn arithmetic(&mut self, op: BinaryOp, ty: &Type, a: Expr, b: Expr) -> Expr {
        let boolean = *ty == Type::BOOL;
        let symbol = match op {
            BinaryOp::Add => "+",
            BinaryOp::Sub => "-",
            BinaryOp::Mul => "*",
            BinaryOp::Div => "/",
            BinaryOp::Rem => match ty.as_float() {
                Some(float) => return self.math("fmod", float, vec![a, b]),
                None => "%",
            },
            // The operands have no effects, so whether both are computed does not show.
            BinaryOp::And if boolean => "&&",
            BinaryOp::Or if boolean => "||",
            BinaryOp::And => "&",
            BinaryOp::Or => "|",
            BinaryOp::Xor => "^",
            BinaryOp::Shl | BinaryOp::Shr => unreachable!("shifts have operands of two types"),
        };
        narrowed(ty, Expr::binary(symbol, a, b))
    }

    /// Returns an operand of a bit operation. Bits above its type may remain, since the result is cast back.
    pub(super) fn bits(&mut self, operand: &Ir) -> Expr {
        if let (ExprKind::Literal(word), Some(int)) = (&operand.kind, operand.ty.as_int()) {
            return literal::bits(int, int.from_word(*word));
        }
        let value = self.word(operand);
        if is_bits(operand) { uncast(value, &operand.ty) } else { value }
    }

    /// Returns a shift by less than the width.
    pub(super) fn shift(&mut self, op: BinaryOp, left: &Ir, right: &Ir) -> Expr {
        let int = left.ty.as_int().expect("the validator asks for integers");
        let narrow = self.counts(right) && self.range(right).is_some() && !self.is_wide(right);
        let count = if narrow { self.narrow(right, false) } else { self.word(right) };
        let left_shift = op == BinaryOp::Shl;
        if int.signed() {
            let helper = if left_shift { Helper::ShiftLeft(int) } else { Helper::ShiftRight(int) };
            let plain = narrow || matches!(right.ty.as_int(), Some(Int::U8 | Int::U16 | Int::U32));
            let count = match right.ty.as_int() {
                Some(held) if !plain => self.as_int(held, Int::U32, count),
                _ => count,
            };
            let value = self.word(left);
            return self.helper(helper, vec![value, count]);
        }
        // Promoted to `int`, the bits of a small unsigned integer could be shifted into the sign. A number alone has the type of
        // fewest bits that holds it, as MISRA C:2012 sees it (rule 12.2).
        let raised = is_small(int) && left_shift;
        let number = matches!(left.kind, ExprKind::Literal(_)) && !right.is_literal();
        let value = if number && (raised || int == Int::U32) {
            Expr::Cast("uint32_t".to_owned(), Box::new(self.word(left)))
        } else if raised {
            self.cast(left, &Type::Scalar(Scalar::Int(Int::U32)))
        } else {
            self.word(left)
        };
        // The count is unsigned, too (MISRA C:2012, rule 10.1).
        let count = match right.ty.as_int() {
            Some(held) if held.signed() && !narrow && !right.is_literal() => {
                self.as_int(held, Int::U32, count)
            }
            _ => count,
        };
        narrowed(&left.ty, Expr::binary(if left_shift { "<<" } else { ">>" }, value, count))
    }

    /// Returns the conversion by Rust's `as`.
    pub(super) fn cast(&mut self, operand: &Ir, to: &Type) -> Expr {
        let Type::Scalar(target) = to else { unreachable!("casts give scalars") };
        let same =
            matches!(operand.ty, Type::Scalar(from) if scalar_type(from) == scalar_type(*target));
        if same {
            return self.word(operand);
        }
        if let Some(direct) = self.without_double(operand, *target) {
            return self.cast(direct, to);
        }
        if let Some(direct) = converted_once(self.context.module, operand, *target) {
            return self.cast(direct, to);
        }
        if *target == Scalar::Int(Int::U32)
            && let Some(direct) = counted(operand)
        {
            return self.word(&direct);
        }
        let narrow =
            self.counts(operand) && self.range(operand).is_some() && !self.is_wide(operand);
        if narrow && *target == Scalar::Int(Int::U32) {
            return self.narrow(operand, false);
        }
        if let Some(flag) = self.foreign_flag(operand) {
            let byte = self.helper(Helper::Flag, vec![flag.address()]);
            return if *target == Scalar::Int(Int::U8) {
                byte
            } else {
                Expr::cast(scalar_type(*target), byte)
            };
        }
        let ty = scalar_type(*target);
        if let (Some(from), Scalar::Int(int)) = (operand.ty.as_int(), target)
            && from.signed()
            && !int.signed()
            && int.bits() <= from.bits()
            && let Some(bits) = self.unsigned_bits(operand)
        {
            return if int.bits() == from.bits() { bits } else { Expr::cast(ty, bits) };
        }
        let value = if narrow { self.narrow(operand, false) } else { self.word(operand) };
        match (&operand.ty, target) {
            (Type::Scalar(Scalar::Float(float)), Scalar::Int(int)) => {
                self.helper(Helper::FromFloat(*int, *float), vec![value])
            }
            // A counter is below 2^31, or 2^31 itself.
            (Type::Scalar(Scalar::Int(_)), Scalar::Int(int))
                if narrow
                    && int.signed()
                    && matches!(value, Expr::Name(_))
                    && self.range(operand).is_some_and(|(_, most)| most <= Int::max(*int)) =>
            {
                Expr::cast(ty, value)
            }
            (Type::Scalar(Scalar::Int(from)), Scalar::Int(int))
                if int.signed() && !fits(*from, *int) =>
            {
                let held = if narrow { Int::U32 } else { *from };
                let bits = self.as_bits(value, held, *int);
                self.helper(Helper::Wrap(*int), vec![bits])
            }
            (Type::Scalar(Scalar::Int(from)), Scalar::Int(Int::U32))
                if from.signed() && is_small(*from) =>
            {
                self.helper(Helper::Extend(*from), vec![value])
            }
            (Type::Enum(id), Scalar::Int(int)) if int.signed() => {
                let all = &self.context.module.enums[id.index()];
                let of_all = all.values(0..=all.variants.len() - 1);
                let all = Int::min(*int)..=Int::max(*int);
                let holds = |value: i32| all.contains(&value.into());
                if of_all.is_some_and(|(low, high)| holds(low) && holds(high)) {
                    Expr::cast(ty, value)
                } else {
                    let bits = Expr::cast(unsigned_type(*int), value);
                    self.helper(Helper::Wrap(*int), vec![bits])
                }
            }
            // The bits that the wider type has no room for, the narrower has none for either.
            (Type::Scalar(Scalar::Int(from)), Scalar::Int(int))
                if is_bits(operand) && !int.signed() && int.bits() <= from.bits() =>
            {
                Expr::cast(ty, uncast(value, &operand.ty))
            }
            (Type::Scalar(from), to) if *from != Scalar::Bool => {
                let from = if narrow { Scalar::Int(Int::U32) } else { *from };
                self.converted(from, *to, value)
            }
            _ => Expr::cast(ty, value),
        }
    }

    /// Converts a value that C holds as `from` to another type. For the result of an operator, a cast to a wider type
    /// or another category would leave open in which type C computes (MISRA C:2012, rule 10.8), so a helper converts
    /// it; also if the conversion rounds.
    pub(super) fn converted(&mut self, from: Scalar, to: Scalar, value: Expr) -> Expr {
        let (kind, bits) = (category(from), width(from));
        let rounds = matches!(to, Scalar::Float(_));
        if is_composite(&value) && (kind != category(to) || bits < width(to) || rounds) {
            return self.helper(Helper::Convert { from, to }, vec![value]);
        }
        Expr::cast(scalar_type(to), value)
    }

    /// Converts an integer like `converted`.
    pub(super) fn as_int(&mut self, from: Int, to: Int, value: Expr) -> Expr {
        self.converted(Scalar::Int(from), Scalar::Int(to), value)
    }

    /// Converts a value that C holds as `from` to the unsigned type of a signed one.
    fn as_bits(&mut self, value: Expr, from: Int, int: Int) -> Expr {
        let same = !from.signed() && from.bits() == int.bits();
        if same { value } else { self.as_int(from, unsigned(int), value) }
    }

    /// Returns the number that is converted to `f32` through an `f64`, if the `f64` holds it exactly; one rounding
    /// then gives the same.
    pub(super) fn without_double<'a>(&self, operand: &'a Ir, target: Scalar) -> Option<&'a Ir> {
        let ExprKind::Cast(inner) = &operand.kind else { return None };
        if target != Scalar::Float(Float::F32) || operand.ty != Type::F64 {
            return None;
        }
        let exact = match inner.ty {
            Type::Scalar(Scalar::Float(_)) => true,
            Type::Scalar(Scalar::Int(int)) => int.bits() <= 32 || self.range(inner).is_some(),
            _ => false,
        };
        exact.then_some(inner)
    }

    /// Returns a `bool` in the caller's memory. Compilers assume that its byte is 0 or 1, and use it as the number.
    fn foreign_flag(&mut self, operand: &Ir) -> Option<Expr> {
        let ExprKind::Load(place) = &operand.kind else { return None };
        let lent = self.function.local(place.root).mode != Mode::Value;
        let flag = operand.ty == Type::BOOL && lent;
        flag.then(|| self.place(place))
    }

    /// Returns an intrinsic function of scalars.
    pub(super) fn intrinsic(&mut self, intrinsic: Intrinsic, operands: &[Ir], ty: &Type) -> Expr {
        let of = &operands[0].ty;
        if let (Intrinsic::Variant, Type::Enum(id)) = (intrinsic, of) {
            return self.variant(&operands[0], *id);
        }
        let Type::Scalar(scalar) = *of else { unreachable!("intrinsics take scalars") };
        if let (Some(sign), Some(int)) = (wrapping_sign(intrinsic), of.as_int()) {
            return self.wrapping(sign, int, operands);
        }
        let mut values: Vec<Expr> = operands.iter().map(|operand| self.word(operand)).collect();
        match (intrinsic, of.as_float(), of.as_int()) {
            (Intrinsic::Sqrt, Some(float), _) => self.math("sqrt", float, values),
            (Intrinsic::Floor, Some(float), _) => self.math("floor", float, values),
            (Intrinsic::Abs, Some(float), _) => self.math("fabs", float, values),
            (Intrinsic::Abs, _, Some(int)) if int.signed() => self.helper(Helper::Abs(int), values),
            (Intrinsic::Abs, _, Some(_)) => values.remove(0),
            (Intrinsic::Min, ..) => self.helper(Helper::Min(scalar), values),
            (Intrinsic::Max, ..) => self.helper(Helper::Max(scalar), values),
            (Intrinsic::Clamp, ..) => self.helper(Helper::Clamp(scalar), values),
            (Intrinsic::ToBits, Some(float), _) => self.helper(Helper::Bits(float), values),
            (Intrinsic::RawBits, Some(float), _) => self.helper(Helper::RawBits(float), values),
            (Intrinsic::FromBits, ..) => {
                let float = ty.as_float().expect("the validator asks for a float");
                self.helper(Helper::FromBits(float), values)
            }
            (Intrinsic::Copysign, Some(float), _) => self.helper(Helper::Copysign(float), values),
            (Intrinsic::Ceil, Some(float), _) => self.math("ceil", float, values),
            (Intrinsic::Trunc, Some(float), _) => self.math("trunc", float, values),
            (Intrinsic::Round, Some(float), _) => self.math("round", float, values),
            (Intrinsic::Signum, Some(float), _) => self.helper(Helper::Signum(float), values),
            (Intrinsic::IsNan, ..) => self.classified("isnan", values),
            (Intrinsic::IsFinite, ..) => self.classified("isfinite", values),
            (Intrinsic::IsInfinite, ..) => self.classified("isinf", values),
            (Intrinsic::DivEuclid, ..) => self.helper(Helper::DivEuclid(scalar), values),
            (Intrinsic::RemEuclid, ..) => self.helper(Helper::RemEuclid(scalar), values),
            (_, _, Some(int)) => self.integer_intrinsic(intrinsic, int, values),
            _ => unreachable!("the validator refuses {intrinsic:?} of {of:?}"),
        }
    }

    fn integer_intrinsic(&mut self, intrinsic: Intrinsic, int: Int, mut values: Vec<Expr>) -> Expr {
        // Counted in `uint32_t`, whose helpers serve the smaller types too.
        let counted = if is_small(int) { Int::U32 } else { int };
        let above = counted.bits() - int.bits();
        let helper = match intrinsic {
            Intrinsic::WrappingDiv => Helper::WrappingDiv(int),
            Intrinsic::WrappingRem => Helper::WrappingRem(int),
            Intrinsic::SaturatingAdd => Helper::SaturatingAdd(int),
            Intrinsic::SaturatingSub => Helper::SaturatingSub(int),
            Intrinsic::SaturatingMul => Helper::SaturatingMul(int),
            Intrinsic::UnsignedAbs => Helper::UnsignedAbs(int),
            Intrinsic::AbsDiff => Helper::AbsDiff(int),
            Intrinsic::SwapBytes => Helper::SwapBytes(int),
            Intrinsic::CountOnes => Helper::CountOnes(counted),
            Intrinsic::LeadingZeros => Helper::LeadingZeros(counted),
            Intrinsic::TrailingZeros => Helper::TrailingZeros(counted),
            _ => unreachable!("the validator refuses {intrinsic:?} of {int:?}"),
        };
        if above > 0 && intrinsic == Intrinsic::TrailingZeros {
            // A bit above the type stops the count at its width.
            let value = Expr::cast("uint32_t", values.remove(0));
            let stop = literal::integer(Int::U32, 1 << int.bits());
            values.push(Expr::binary("|", value, stop));
        }
        let count = self.helper(helper, values);
        if above > 0 && intrinsic == Intrinsic::LeadingZeros {
            let surplus = literal::integer(Int::U32, i128::from(above));
            return Expr::binary("-", count, surplus);
        }
        count
    }

    /// Returns a classification macro of `math.h` as a condition.
    fn classified(&mut self, name: &str, values: Vec<Expr>) -> Expr {
        self.uses.system.insert("math.h");
        let zero = literal::integer(Int::I32, 0);
        Expr::binary("!=", Expr::call(name.to_owned(), values), zero)
    }

    /// Computes modulo 2^bits by unsigned arithmetic.
    fn wrapping(&mut self, op: &'static str, int: Int, operands: &[Ir]) -> Expr {
        let bits = self.wrapping_bits(op, int, operands);
        if int.signed() { self.helper(Helper::Wrap(int), vec![bits]) } else { bits }
    }

    /// Computes a wrapping operation before its conversion back to a signed type.
    fn wrapping_bits(&mut self, op: &'static str, int: Int, operands: &[Ir]) -> Expr {
        let wide = if is_small(int) { Int::U32 } else { unsigned(int) };
        let own = int.signed() || is_small(int);
        let mut values = operands.iter().map(|operand| {
            let bits =
                if is_small(int) { self.modular(operand) } else { self.unsigned_bits(operand) };
            match bits {
                Some(bits) => bits,
                None if own => self.unsigned_operand(operand, int, wide),
                None => self.word(operand),
            }
        });
        let (Some(a), Some(b)) = (values.next(), values.next()) else {
            unreachable!("two operands")
        };
        let result = Expr::binary(op, a, b);
        if is_small(int) { Expr::cast(unsigned_type(int), result) } else { result }
    }

    /// Returns an operand of type `int` in the unsigned type `wide`.
    fn unsigned_operand(&mut self, operand: &Ir, int: Int, wide: Int) -> Expr {
        if let Some(direct) = converted_once(self.context.module, operand, Scalar::Int(wide)) {
            return self.cast(direct, &Type::Scalar(Scalar::Int(wide)));
        }
        match counted(operand) {
            Some(counted) => self.word(&counted),
            None => {
                let value = self.word(operand);
                self.as_int(int, wide, value)
            }
        }
    }

    /// Returns a small value that is computed modulo 2^bits, without the cast to its type.
    fn modular(&mut self, operand: &Ir) -> Option<Expr> {
        let int = operand.ty.as_int()?;
        let ExprKind::Intrinsic(intrinsic, operands) = &operand.kind else { return None };
        let bits = self.wrapping_bits(wrapping_sign(*intrinsic)?, int, operands);
        let ty = Type::Scalar(Scalar::Int(unsigned(int)));
        Some(uncast(bits, &ty))
    }

    /// Returns the bits of a signed value that unsigned arithmetic computes, without the conversion to the signed
    /// type.
    fn unsigned_bits(&mut self, operand: &Ir) -> Option<Expr> {
        let int = operand.ty.as_int().filter(|int| int.signed())?;
        if super::range::never_reached(operand).is_some() {
            return None;
        }
        match &operand.kind {
            ExprKind::Intrinsic(intrinsic, operands) => {
                Some(self.wrapping_bits(wrapping_sign(*intrinsic)?, int, operands))
            }
            ExprKind::Cast(inner) => {
                let from = inner.ty.as_int().filter(|from| !from.signed() && !fits(*from, int))?;
                if self.counts(inner) && self.range(inner).is_some() {
                    return None;
                }
                let value = self.word(inner);
                Some(self.as_bits(value, from, int))
            }
            _ => None,
        }
    }

    /// Returns a call of a function of `math.h`.
    pub(super) fn math(&mut self, name: &str, float: Float, values: Vec<Expr>) -> Expr {
        self.uses.system.insert("math.h");
        Expr::call(if float == Float::F32 { format!("{name}f") } else { name.to_owned() }, values)
    }
}

/// Returns the operator of an intrinsic that computes modulo 2^bits.
fn wrapping_sign(intrinsic: Intrinsic) -> Option<&'static str> {
    match intrinsic {
        Intrinsic::WrappingAdd => Some("+"),
        Intrinsic::WrappingSub => Some("-"),
        Intrinsic::WrappingMul => Some("*"),
        _ => None,
    }
}

/// Returns true if an expression is composite in the sense of MISRA C:2012: its outermost operator computes in the type
/// of its operands.
fn is_composite(value: &Expr) -> bool {
    match value {
        Expr::Binary(op, ..) => {
            matches!(*op, "+" | "-" | "*" | "/" | "%" | "&" | "|" | "^" | "<<" | ">>")
        }
        Expr::Unary(op, _) => *op == "~",
        Expr::Conditional(..) => true,
        _ => false,
    }
}

/// Returns the category of a type: boolean, signed, unsigned or floating.
fn category(scalar: Scalar) -> u8 {
    match scalar {
        Scalar::Bool => 0,
        Scalar::Int(int) if int.signed() => 1,
        Scalar::Int(_) => 2,
        Scalar::Float(_) => 3,
    }
}

fn width(scalar: Scalar) -> u32 {
    match scalar {
        Scalar::Bool => 1,
        Scalar::Int(int) => int.bits(),
        Scalar::Float(Float::F32) => 32,
        Scalar::Float(Float::F64) => 64,
    }
}
