//! Methods of numbers that are put together from operations of the IR.
//!
//! One that the IR has is in [`builtin`](super::builtin); what stands here is spelt out, as a reader of
//! the C would write it, each operand computed once.
//!
//! Invariant: each method is one arm of [`method`], which the compiler holds to be complete.

use bessemer_ir::tree::{self, ByteOrder, NumberMethod};
use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Float, Int, Intrinsic, Place, Scalar, Span, Step, Type,
    UnaryOp,
};

use super::expr::Operand;
use super::lowering::Lowering;
use super::words;
use super::{OUR_FAULT, Result, problem};

/// A method of a number.
#[derive(Clone, Copy)]
enum Method {
    One(One),
    Two(Two),
}

/// A method without arguments.
#[derive(Clone, Copy)]
enum One {
    Recip,
    Fract,
    ToDegrees,
    ToRadians,
    Signum,
    /// How the sign of a float, its zero included, compares with 0.
    Sign(CompareOp),
    /// How a number compares with 0.
    Compared(CompareOp),
    WrappingNeg,
    WrappingAbs,
    SwapBytes,
    IsPowerOfTwo,
    From,
    /// An intrinsic that counts the bits of an unsigned integer.
    Bits(Intrinsic),
    /// The same, of the opposite bits.
    OppositeBits(Intrinsic),
}

/// A method with one argument.
#[derive(Clone, Copy)]
enum Two {
    /// An operator where numbers have no sign, else an intrinsic.
    BySign(BinaryOp, Intrinsic),
    AbsDiff,
    /// A shift by a number of places modulo the width.
    Shift(BinaryOp),
    RotateLeft,
    RotateRight,
}

/// How a method is put together.
fn method(it: NumberMethod) -> Method {
    use Method::{One as O, Two as T};
    match it {
        NumberMethod::Recip => O(One::Recip),
        NumberMethod::Fract => O(One::Fract),
        NumberMethod::ToDegrees => O(One::ToDegrees),
        NumberMethod::ToRadians => O(One::ToRadians),
        NumberMethod::Signum => O(One::Signum),
        NumberMethod::IsSignNegative => O(One::Sign(CompareOp::Lt)),
        NumberMethod::IsSignPositive => O(One::Sign(CompareOp::Gt)),
        NumberMethod::IsNegative => O(One::Compared(CompareOp::Lt)),
        NumberMethod::IsPositive => O(One::Compared(CompareOp::Gt)),
        NumberMethod::WrappingNeg => O(One::WrappingNeg),
        NumberMethod::WrappingAbs => O(One::WrappingAbs),
        NumberMethod::SwapBytes => O(One::SwapBytes),
        NumberMethod::IsPowerOfTwo => O(One::IsPowerOfTwo),
        NumberMethod::From => O(One::From),
        NumberMethod::CountOnes => O(One::Bits(Intrinsic::CountOnes)),
        NumberMethod::CountZeros => O(One::OppositeBits(Intrinsic::CountOnes)),
        NumberMethod::LeadingZeros => O(One::Bits(Intrinsic::LeadingZeros)),
        NumberMethod::LeadingOnes => O(One::OppositeBits(Intrinsic::LeadingZeros)),
        NumberMethod::TrailingZeros => O(One::Bits(Intrinsic::TrailingZeros)),
        NumberMethod::TrailingOnes => O(One::OppositeBits(Intrinsic::TrailingZeros)),
        NumberMethod::DivEuclid => T(Two::BySign(BinaryOp::Div, Intrinsic::DivEuclid)),
        NumberMethod::RemEuclid => T(Two::BySign(BinaryOp::Rem, Intrinsic::RemEuclid)),
        NumberMethod::WrappingDiv => T(Two::BySign(BinaryOp::Div, Intrinsic::WrappingDiv)),
        NumberMethod::WrappingRem => T(Two::BySign(BinaryOp::Rem, Intrinsic::WrappingRem)),
        NumberMethod::AbsDiff => T(Two::AbsDiff),
        NumberMethod::WrappingShl => T(Two::Shift(BinaryOp::Shl)),
        NumberMethod::WrappingShr => T(Two::Shift(BinaryOp::Shr)),
        NumberMethod::RotateLeft => T(Two::RotateLeft),
        NumberMethod::RotateRight => T(Two::RotateRight),
    }
}

impl One {
    /// Whether a literal before it is of the result's type.
    fn keeps_type(self) -> bool {
        match self {
            One::Recip | One::Fract | One::ToDegrees | One::ToRadians | One::Signum => true,
            One::WrappingNeg | One::WrappingAbs | One::SwapBytes => true,
            One::Sign(_) | One::Compared(_) | One::IsPowerOfTwo | One::From => false,
            One::Bits(_) | One::OppositeBits(_) => false,
        }
    }

    /// Whether it mentions its operand more than once.
    fn repeats(self) -> bool {
        matches!(self, One::Fract | One::Signum)
    }

    /// The value for `x`, of type `ty`.
    fn of(self, x: Expr, ty: &Type, span: Span) -> Expr {
        let zero = Expr::literal(0, x.ty.clone(), span);
        match self {
            One::Recip => Expr::binary(BinaryOp::Div, float(1.0, 1.0, ty, span), x),
            One::Fract => {
                let whole = Expr::intrinsic(Intrinsic::Trunc, vec![x.clone()]);
                Expr::binary(BinaryOp::Sub, x, whole)
            }
            // As core has them: the factor rounded once, for `f32` from more digits.
            One::ToDegrees => {
                let factor = 180.0 / core::f64::consts::PI;
                Expr::binary(BinaryOp::Mul, x, float(factor, factor as f32, ty, span))
            }
            One::ToRadians => {
                let (double, single) =
                    (core::f64::consts::PI / 180.0, core::f32::consts::PI / 180.0);
                Expr::binary(BinaryOp::Mul, x, float(double, single, ty, span))
            }
            One::Signum if x.ty.as_float().is_some() => Expr::intrinsic(Intrinsic::Signum, vec![x]),
            One::Signum => {
                let above = Expr::compare(CompareOp::Gt, x.clone(), zero.clone());
                let below = Expr::compare(CompareOp::Lt, x, zero);
                Expr::binary(BinaryOp::Sub, above.cast(ty), below.cast(ty))
            }
            One::Sign(op) => {
                let (one, nothing) = (float(1.0, 1.0, &x.ty, span), float(0.0, 0.0, &x.ty, span));
                Expr::compare(op, Expr::intrinsic(Intrinsic::Copysign, vec![one, x]), nothing)
            }
            One::Compared(op) => Expr::compare(op, x, zero),
            One::WrappingNeg => Expr::intrinsic(Intrinsic::WrappingSub, vec![zero, x]),
            One::WrappingAbs => Expr::intrinsic(Intrinsic::UnsignedAbs, vec![x]).cast(ty),
            One::SwapBytes if x.ty.as_int().is_some_and(|int| int.bits() == 8) => x,
            One::SwapBytes => Expr::intrinsic(Intrinsic::SwapBytes, vec![unsigned(x)]).cast(ty),
            One::IsPowerOfTwo => {
                let count = Expr::intrinsic(Intrinsic::CountOnes, vec![x]);
                Expr::compare(CompareOp::Eq, count, Expr::literal(1, U32, span))
            }
            One::From => x.cast(ty),
            One::Bits(op) => Expr::intrinsic(op, vec![unsigned(x)]),
            One::OppositeBits(op) => {
                Expr::intrinsic(op, vec![Expr::unary(UnaryOp::Not, unsigned(x))])
            }
        }
    }
}

impl Two {
    /// The value for `a` and `b`, of type `ty`; none if they are of types that it does not take.
    fn of(self, a: Expr, b: Expr, ty: &Type, span: Span) -> Option<Expr> {
        let int = a.ty.as_int();
        Some(match self {
            Two::BySign(op, _) if int.is_some_and(|int| !int.signed()) => Expr::binary(op, a, b),
            Two::BySign(_, op) => Expr::intrinsic(op, vec![a, b]),
            Two::AbsDiff => Expr::intrinsic(Intrinsic::AbsDiff, vec![a, b]),
            Two::Shift(op) => Expr::binary(op, a, masked(b, int?)),
            Two::RotateLeft => {
                let (by, back) = (masked(b.clone(), int?), to_whole(b, int?, span));
                rotated(a, by, back).cast(ty)
            }
            Two::RotateRight => {
                let (by, back) = (masked(b.clone(), int?), to_whole(b, int?, span));
                rotated(a, back, by).cast(ty)
            }
        })
    }
}

fn float(double: f64, single: f32, ty: &Type, span: Span) -> Expr {
    let word = match ty.as_float() {
        Some(Float::F32) => u64::from(single.to_bits()),
        _ => double.to_bits(),
    };
    Expr::literal(word, ty.clone(), span)
}

/// The bits of an integer, unsigned.
fn unsigned(x: Expr) -> Expr {
    match x.ty.as_int() {
        Some(int) => x.cast(&of(int.unsigned())),
        None => x,
    }
}

/// `n` modulo the width of `int`.
fn masked(n: Expr, int: Int) -> Expr {
    let mask = u64::from(int.bits() - 1);
    match n.kind {
        ExprKind::Literal(word) => Expr::literal_like(word & mask, &n),
        _ => {
            let mask = Expr::literal_like(mask, &n);
            Expr::binary(BinaryOp::And, n, mask)
        }
    }
}

/// By how many places more bits have come round after `n`, modulo the width of `int`.
fn to_whole(n: Expr, int: Int, span: Span) -> Expr {
    match n.kind {
        ExprKind::Literal(word) => {
            let back = (word as u32).wrapping_neg() & (int.bits() - 1);
            Expr::literal_like(back.into(), &n)
        }
        _ => {
            let zero = Expr::literal(0, U32, span);
            masked(Expr::intrinsic(Intrinsic::WrappingSub, vec![zero, n]), int)
        }
    }
}

/// The bits of an integer shifted left, and those that come round.
fn rotated(x: Expr, left: Expr, right: Expr) -> Expr {
    let bits = unsigned(x);
    let high = Expr::binary(BinaryOp::Shl, bits.clone(), left);
    let low = Expr::binary(BinaryOp::Shr, bits, right);
    Expr::binary(BinaryOp::Or, high, low)
}

fn of(int: Int) -> Type {
    Type::Scalar(Scalar::Int(int))
}

const U32: Type = Type::Scalar(Scalar::Int(Int::U32));

impl Lowering<'_, '_> {
    /// The value of a method of numbers.
    pub(super) fn number_method(
        &mut self,
        called: NumberMethod,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let method = method(called);
        let ty = self.slot_of(expr)?;
        // What a literal operand is expected to be.
        let same = Some(ty.clone());
        let expected = match method {
            Method::One(method) => [same.filter(|_| method.keeps_type()), None],
            Method::Two(Two::BySign(..)) => [same.clone(), same],
            Method::Two(Two::AbsDiff) => [None, self.partner(arguments)?],
            Method::Two(Two::Shift(_) | Two::RotateLeft | Two::RotateRight) => [same, Some(U32)],
        };
        let operands = arguments.iter().zip(words::OF_NUMBERS).zip(expected);
        let operands: Vec<_> =
            operands.map(|((expr, role), expected)| Operand { expr, expected, role }).collect();
        let values = self.operands(&operands)?;
        let span = self.span(expr.site);
        let repeats = match method {
            Method::One(method) => method.repeats(),
            Method::Two(method) => matches!(method, Two::RotateLeft | Two::RotateRight),
        };
        let values = if repeats { self.reusable(values) } else { values };
        let value = match (method, <[Expr; 1]>::try_from(values)) {
            (Method::One(method), Ok([x])) => Some(method.of(x, &ty, span)),
            (Method::Two(method), Err(values)) => match <[Expr; 2]>::try_from(values) {
                Ok([a, b]) => method.of(a, b, &ty, span),
                Err(_) => None,
            },
            _ => None,
        };
        match value {
            Some(value) => Ok(value.at(span)),
            None => problem(expr.site, format!("{called:?} takes other operands"), OUR_FAULT),
        }
    }

    /// The type of the first operand, where a literal beside it has it too.
    fn partner(&mut self, arguments: &[tree::Expr]) -> Result<Option<Type>> {
        match arguments {
            [first, tree::Expr { kind: tree::ExprKind::Int(_, None), .. }] => {
                self.type_alone(first).map(Some)
            }
            [first, tree::Expr { kind: tree::ExprKind::Unary(..), .. }] => {
                self.type_alone(first).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// Values that may be written more than once: where one has to be computed before, all are.
    fn reusable(&mut self, values: Vec<Expr>) -> Vec<Expr> {
        fn light(value: &Expr) -> bool {
            match &value.kind {
                ExprKind::Literal(_) | ExprKind::Const(_) => true,
                ExprKind::Load(place) => {
                    place.steps.iter().all(|step| matches!(step, Step::Field(_)))
                }
                _ => false,
            }
        }
        if values.iter().all(light) {
            return values;
        }
        let constant =
            |value: &Expr| matches!(value.kind, ExprKind::Literal(_) | ExprKind::Const(_));
        let kept = values.into_iter().zip(words::OF_NUMBERS).map(|(value, role)| {
            if constant(&value) { value } else { self.temporary(role, value) }
        });
        kept.collect()
    }

    /// The square or the cube of an integer, which need no loop; none if it is another call.
    pub(super) fn small_power(
        &mut self,
        path: &str,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Option<Expr>> {
        let Some(name) = path.strip_prefix("bessemer::math::integer::") else { return Ok(None) };
        let wrapping = name.starts_with("wrapping_pow");
        let exponent = match arguments {
            [_, tree::Expr { kind: tree::ExprKind::Int(digits, _), .. }] => digits.as_str(),
            _ => return Ok(None),
        };
        if !matches!(exponent, "2" | "3") {
            return Ok(None);
        }
        let ty = self.slot_of(expr)?;
        let base = self.value(&arguments[0], Some(&ty))?;
        let span = self.span(expr.site);
        let product = |a: Expr, b: Expr| match wrapping {
            true => Expr::intrinsic(Intrinsic::WrappingMul, vec![a, b]).at(span),
            false => Expr::binary(BinaryOp::Mul, a, b).at(span),
        };
        let x = self.reusable(vec![base]).remove(0);
        let square = product(x.clone(), x.clone());
        Ok(Some(if exponent == "2" { square } else { product(square, x) }))
    }

    /// The bytes of a number as an array, or the number that they make.
    pub(super) fn bytes(
        &mut self,
        order: ByteOrder,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let ty = self.slot_of(expr)?;
        let span = self.span(expr.site);
        let big = order == ByteOrder::Big;
        let byte = of(Int::U8);
        let argument = self.value(&arguments[0], None)?;
        if let Type::Array { len, .. } = ty {
            let value = match argument.ty.as_float() {
                Some(_) => Expr::intrinsic(Intrinsic::ToBits, vec![argument]),
                None => unsigned(argument),
            };
            let value = self.reusable(vec![value]).remove(0);
            let bytes = (0..len).map(|index| {
                let place = if big { len - 1 - index } else { index };
                let shifted = match place {
                    0 => value.clone(),
                    _ => {
                        let by = Expr::literal(u64::from(8 * place), U32, span);
                        Expr::binary(BinaryOp::Shr, value.clone(), by)
                    }
                };
                shifted.cast(&byte)
            });
            return self.node(ExprKind::Array(bytes.collect()), ty, expr.site);
        }
        let bytes = match &argument.kind {
            ExprKind::Load(place) if place.steps.iter().all(|it| matches!(it, Step::Field(_))) => {
                argument
            }
            _ => self.temporary("bytes", argument),
        };
        let (ExprKind::Load(place), Type::Array { len, .. }) = (&bytes.kind, &bytes.ty) else {
            return problem(expr.site, "these are no bytes", OUR_FAULT);
        };
        let word = match (ty.as_float(), ty.as_int()) {
            (Some(float), _) => of(float.bits_type()),
            (_, Some(int)) => of(int.unsigned()),
            _ => U32,
        };
        let mut total: Option<Expr> = None;
        for index in 0..*len {
            let step = Step::Index(Expr::usize(u64::from(index), span));
            let value = Place { span, ..place.inside(step, byte.clone()) }.load().cast(&word);
            let weight = if big { len - 1 - index } else { index };
            let value = match weight {
                0 => value,
                _ => {
                    let by = Expr::literal(u64::from(8 * weight), U32, span);
                    Expr::binary(BinaryOp::Shl, value, by)
                }
            };
            total = Some(match total {
                None => value,
                Some(total) => Expr::binary(BinaryOp::Or, total, value),
            });
        }
        let bits = total.unwrap_or_else(|| Expr::literal(0, word, span));
        Ok(match ty.as_float() {
            Some(_) => Expr::intrinsic(Intrinsic::FromBits, vec![bits]).at(span),
            None => bits.cast(&ty).at(span),
        })
    }
}
