//! Methods of numbers that are composed of IR operations.
//!
//! A method that is one IR operation is in [`builtin`](super::builtin). The others are written out here as a reader
//! of the C would write them, with each operand evaluated once.
//!
//! Invariant: each method is one arm of [`spelt_out`], an exhaustive `match`.

use bessemer_ir::tree::{self, ByteOrder, NumberMethod, Site};
use bessemer_ir::{
    BinaryOp, CompareOp, Const, Expr, ExprKind, Float, Int, Intrinsic, LogicOp, Place, Scalar,
    Span, Step, Type, UnaryOp,
};

use super::conditions::within;
use super::expr::{Call, Operand};
use super::lowering::Lowering;
use super::order::is_light;
use super::words;
use super::{Needed, OUR_FAULT, Result, literal, problem, struct_of};

/// Returns the value of a method for `x`, the argument `by` and the type `ty`; none for types without this method.
fn spelt_out(
    method: NumberMethod,
    x: Expr,
    by: Option<Expr>,
    ty: &Type,
    span: Span,
) -> Option<Expr> {
    use NumberMethod as M;
    let int = x.ty.as_int();
    let zero = Expr::literal(0, x.ty.clone(), span);
    // What counts bits takes those of an unsigned integer, or their opposites.
    let bits = |op, x| Expr::intrinsic(op, vec![unsigned(x)]);
    let opposite_bits = |op, x| Expr::intrinsic(op, vec![Expr::unary(UnaryOp::Not, unsigned(x))]);
    let sign = |x: Expr| Expr::intrinsic(Intrinsic::Copysign, vec![number(1, &x.ty, span), x]);
    // An operator where numbers have no sign, else an intrinsic.
    let by_sign = |operator, intrinsic, x: Expr, by| match int {
        Some(int) if !int.signed() => Expr::binary(operator, x, by),
        _ => Expr::intrinsic(intrinsic, vec![x, by]),
    };
    Some(match method {
        M::Recip => Expr::binary(BinaryOp::Div, number(1, ty, span), x),
        M::Fract => {
            let whole = Expr::intrinsic(Intrinsic::Trunc, vec![x.clone()]);
            Expr::binary(BinaryOp::Sub, x, whole)
        }
        // As core has them: the factor rounded once, for `f32` from more digits.
        M::ToDegrees => {
            let factor = 180.0 / core::f64::consts::PI;
            Expr::binary(BinaryOp::Mul, x, float(factor, factor as f32, ty, span))
        }
        M::ToRadians => {
            let (double, single) = (core::f64::consts::PI / 180.0, core::f32::consts::PI / 180.0);
            Expr::binary(BinaryOp::Mul, x, float(double, single, ty, span))
        }
        M::Signum if x.ty.as_float().is_some() => Expr::intrinsic(Intrinsic::Signum, vec![x]),
        M::Signum => {
            let above = Expr::compare(CompareOp::Gt, x.clone(), zero.clone());
            let below = Expr::compare(CompareOp::Lt, x, zero);
            Expr::binary(BinaryOp::Sub, above.cast(ty), below.cast(ty))
        }
        M::IsSignNegative => Expr::compare(CompareOp::Lt, sign(x), zero),
        M::IsSignPositive => Expr::compare(CompareOp::Gt, sign(x), zero),
        M::IsNegative => Expr::compare(CompareOp::Lt, x, zero),
        M::IsPositive => Expr::compare(CompareOp::Gt, x, zero),
        M::WrappingNeg => Expr::intrinsic(Intrinsic::WrappingSub, vec![zero, x]),
        M::WrappingAbs => Expr::intrinsic(Intrinsic::UnsignedAbs, vec![x]).cast(ty),
        M::SwapBytes if int.is_some_and(|int| int.bits() == 8) => x,
        M::SwapBytes => bits(Intrinsic::SwapBytes, x).cast(ty),
        M::IsPowerOfTwo => {
            let count = Expr::intrinsic(Intrinsic::CountOnes, vec![x]);
            Expr::compare(CompareOp::Eq, count, Expr::literal(1, U32, span))
        }
        M::From => x.cast(ty),
        M::CountOnes => bits(Intrinsic::CountOnes, x),
        M::CountZeros => opposite_bits(Intrinsic::CountOnes, x),
        M::LeadingZeros => bits(Intrinsic::LeadingZeros, x),
        M::LeadingOnes => opposite_bits(Intrinsic::LeadingZeros, x),
        M::TrailingZeros => bits(Intrinsic::TrailingZeros, x),
        M::TrailingOnes => opposite_bits(Intrinsic::TrailingZeros, x),
        M::DivEuclid => by_sign(BinaryOp::Div, Intrinsic::DivEuclid, x, by?),
        M::RemEuclid => by_sign(BinaryOp::Rem, Intrinsic::RemEuclid, x, by?),
        M::WrappingDiv => by_sign(BinaryOp::Div, Intrinsic::WrappingDiv, x, by?),
        M::WrappingRem => by_sign(BinaryOp::Rem, Intrinsic::WrappingRem, x, by?),
        M::AbsDiff => Expr::intrinsic(Intrinsic::AbsDiff, vec![x, by?]),
        M::WrappingShl => Expr::binary(BinaryOp::Shl, x, masked(by?, int?)),
        M::WrappingShr => Expr::binary(BinaryOp::Shr, x, masked(by?, int?)),
        M::ShiftLeft => Expr::binary(BinaryOp::Shl, x, by?),
        M::UnsignedShr => Expr::binary(BinaryOp::Shr, unsigned(x), by?).cast(ty),
        M::SignedShr => Expr::binary(BinaryOp::Shr, x.cast(&of(int?.with_sign())), by?).cast(ty),
        M::RotateLeft | M::RotateRight => {
            let by = by?;
            let mut places = [masked(by.clone(), int?), masked(negative(by, span), int?)];
            if method == M::RotateRight {
                places.reverse();
            }
            let [left, right] = places;
            let high = Expr::binary(BinaryOp::Shl, unsigned(x.clone()), left);
            let low = Expr::binary(BinaryOp::Shr, unsigned(x), right);
            Expr::binary(BinaryOp::Or, high, low).cast(ty)
        }
    })
}

pub(super) fn float(double: f64, single: f32, ty: &Type, span: Span) -> Expr {
    let word = match ty.as_float() {
        Some(Float::F32) => u64::from(single.to_bits()),
        _ => double.to_bits(),
    };
    Expr::literal(word, ty.clone(), span)
}

/// Returns the literal 0 or 1 of a scalar type.
pub(super) fn number(value: u8, ty: &Type, span: Span) -> Expr {
    match ty.as_float() {
        Some(_) => float(value.into(), value.into(), ty, span),
        None => Expr::literal(value.into(), ty.clone(), span),
    }
}

/// Casts an integer to the unsigned type of its width.
fn unsigned(x: Expr) -> Expr {
    match x.ty.as_int() {
        Some(int) => x.cast(&of(int.unsigned())),
        None => x,
    }
}

/// Returns `n` modulo the width of `int`.
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

/// Returns `-n`, with wrapping.
fn negative(n: Expr, span: Span) -> Expr {
    match n.kind {
        ExprKind::Literal(word) => Expr::literal_like(word.wrapping_neg(), &n),
        _ => Expr::intrinsic(Intrinsic::WrappingSub, vec![Expr::literal(0, U32, span), n]),
    }
}

fn of(int: Int) -> Type {
    Type::Scalar(Scalar::Int(int))
}

const U32: Type = Type::Scalar(Scalar::Int(Int::U32));

impl Lowering<'_, '_> {
    /// Lowers a method of numbers.
    pub(super) fn number_method(&mut self, method: NumberMethod, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        use NumberMethod as M;
        let ty = self.slot_of(expr)?;
        let same = Some(ty.clone());
        // What literal operands are expected to be.
        let expected = match method {
            M::WrappingShl | M::WrappingShr | M::RotateLeft | M::RotateRight => [same, Some(U32)],
            M::ShiftLeft | M::UnsignedShr | M::SignedShr => [same, Some(U32)],
            M::IsSignNegative | M::IsSignPositive | M::IsNegative | M::IsPositive => [None, None],
            M::CountOnes | M::LeadingOnes | M::TrailingOnes => [None, None],
            M::CountZeros | M::LeadingZeros | M::TrailingZeros => [None, None],
            M::IsPowerOfTwo | M::From | M::AbsDiff => [None, None],
            _ => [same.clone(), same],
        };
        let operands = arguments.iter().zip(words::OF_NUMBERS).zip(expected);
        let operands: Vec<_> =
            operands.map(|((expr, role), expected)| Operand { expr, expected, role }).collect();
        let mut values = match <[Operand<'_>; 2]>::try_from(operands) {
            Ok(both) if method == M::AbsDiff => self.beside_literal(both, expr.site)?.into(),
            Ok(both) => self.operands(&both)?,
            Err(operands) => self.operands(&operands)?,
        };
        if matches!(method, M::Fract | M::Signum | M::RotateLeft | M::RotateRight) {
            values = self.reusable(values);
        }
        let (span, mut values) = (self.span(expr.site), values.into_iter());
        let value = values.next().and_then(|x| spelt_out(method, x, values.next(), &ty, span));
        let value = value.needed(expr.site, format!("{method:?} takes other operands"))?;
        Ok(value.at(span))
    }

    /// Returns operands that may be read more than once: if one needs a temporary, all have one.
    fn reusable(&mut self, values: Vec<Expr>) -> Vec<Expr> {
        let kept = values.into_iter().zip(words::OF_NUMBERS);
        kept.map(|(value, role)| self.atom(role, value)).collect()
    }

    /// Returns the square or the cube of an integer, which need no loop; none for another call.
    pub(super) fn small_power(&mut self, path: &str, call: Call<'_>) -> Result<Option<Expr>> {
        let Call { arguments, expr } = call;
        let Some(name) = path.strip_prefix("bessemer::math::integer::") else { return Ok(None) };
        // `pow_u8` or `wrapping_pow_u8`: the module has other functions of two numbers.
        let kind = name.rsplit_once('_').and_then(|(kind, _)| kind.strip_suffix("pow"));
        let Some(wrapping) = kind.map(|before| !before.is_empty()) else { return Ok(None) };
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

    /// Lowers the conversion of a number to its bytes, or of bytes to a number.
    pub(super) fn bytes_of_number(&mut self, order: ByteOrder, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        let (ty, span) = (self.slot_of(expr)?, self.span(expr.site));
        let byte = of(Int::U8);
        // The byte at an index, shifted from or to its place.
        let shifted = |op, value: Expr, len: u32, index: u32| {
            let places = if order == ByteOrder::Big { len - 1 - index } else { index };
            match places {
                0 => value,
                _ => Expr::binary(op, value, Expr::literal(u64::from(8 * places), U32, span)),
            }
        };
        let argument = self.value(&arguments[0], None)?;
        if let Type::Array { len, .. } = ty {
            let value = match argument.ty.as_float() {
                Some(_) => Expr::intrinsic(Intrinsic::ToBits, vec![argument]),
                None => unsigned(argument),
            };
            let value = self.reusable(vec![value]).remove(0);
            let bytes =
                (0..len).map(|at| shifted(BinaryOp::Shr, value.clone(), len, at).cast(&byte));
            return self.node(ExprKind::Array(bytes.collect()), ty, expr.site);
        }
        let place = match argument.kind {
            ExprKind::Load(ref place) if is_light(&argument) => place.clone(),
            _ => self.atom_place("bytes", argument),
        };
        let Type::Array { len, .. } = place.ty else {
            return problem(expr.site, "these are no bytes", OUR_FAULT);
        };
        let int = ty.as_float().map(Float::bits_type).or(ty.as_int().map(Int::unsigned));
        let word = int.map_or(U32, of);
        let all = (0..len).map(|at| {
            let step = Step::Index(Expr::usize(u64::from(at), span));
            let value = Place { span, ..place.inside(step, byte.clone()) }.load().cast(&word);
            shifted(BinaryOp::Shl, value, len, at)
        });
        let bits = all.reduce(|total, value| Expr::binary(BinaryOp::Or, total, value));
        let bits = bits.unwrap_or_else(|| Expr::literal(0, word.clone(), span));
        Ok(match ty.as_float() {
            Some(_) => Expr::intrinsic(Intrinsic::FromBits, vec![bits]).at(span),
            None => bits.cast(&ty).at(span),
        })
    }

    /// Lowers `u8::try_from(x)` of an integer, and `num_traits::cast(x)` of any number: tests the range before the
    /// conversion.
    pub(super) fn if_it_fits(&mut self, argument: &tree::Expr, expr: &tree::Expr) -> Result<Expr> {
        let (result, span) = (self.slot_of(expr)?, self.span(expr.site));
        let value = self.value(argument, None)?;
        let id = struct_of(&result, expr.site, "a `Result` or an `Option`")?;
        let name = self.going_on(id).needed(expr.site, "this is no `Result` and no `Option`")?;
        let target = self.payload_type(id, name).unwrap_or(Type::Unit);
        if target.as_float().is_some() {
            // Every number is some float.
            let number = self.as_float(value, target, expr.site)?;
            return self.choice(id, 1, Some(number), expr.site);
        }
        let place = self.hold(value);
        let x = place.load();
        let condition = match (place.ty.as_int(), place.ty.as_float(), target.as_int()) {
            (Some(from), _, Some(to)) => {
                within(&x, (from.min().max(to.min()), from.max().min(to.max())), span)
            }
            (_, Some(from), Some(to)) => within_integers(&x, from, to, span),
            _ => return problem(expr.site, "this converts numbers", OUR_FAULT),
        };
        let number = self.node(ExprKind::Cast(Box::new(x)), target, expr.site)?;
        let there = self.choice(id, 1, Some(number), expr.site)?;
        if condition.is_literal() {
            return Ok(there);
        }
        let nothing = self.choice(id, 0, None, expr.site)?;
        Ok(self.either("narrowed", nothing, (condition, there), span))
    }

    /// Converts a number to a float type; a literal becomes one of that type.
    pub(super) fn as_float(&mut self, value: Expr, ty: Type, site: Site) -> Result<Expr> {
        if let Some(literal) = literal::converted(&value, &ty) {
            return Ok(literal);
        }
        let kind = match value.kind {
            _ if value.ty == ty => return Ok(value),
            ExprKind::Literal(word) if ty == Type::F32 => ExprKind::Literal(single(word)),
            // `real(GAIN)` in single precision is a constant of its own.
            ExprKind::Const(id) if ty == Type::F32 && value.ty == Type::F64 => {
                let Const { name, module, words, .. } = self.cx.module.consts[id.index()].clone();
                let words: Vec<_> = words.into_iter().map(single).collect();
                ExprKind::Const(self.cx.constant(&module, &format!("{name}_F32"), &ty, &words))
            }
            ExprKind::Unary(UnaryOp::Neg, operand) if ty == Type::F32 && value.ty == Type::F64 => {
                let kind = match operand.kind {
                    ExprKind::Literal(word) => ExprKind::Literal(single(word)),
                    _ => ExprKind::Cast(operand.clone()),
                };
                let rounded = Expr { kind, ty: ty.clone(), span: operand.span };
                ExprKind::Unary(UnaryOp::Neg, Box::new(rounded))
            }
            _ => ExprKind::Cast(Box::new(value)),
        };
        self.node(kind, ty, site)
    }
}

/// Converts the bits of an `f64` to those of the nearest `f32`.
fn single(word: u64) -> u64 {
    u64::from((f64::from_bits(word) as f32).to_bits())
}

/// Returns the condition that a float, rounded towards zero, is a value of an integer.
fn within_integers(x: &Expr, from: Float, to: Int, span: Span) -> Expr {
    let limit = |value: f64| float(value, value as f32, &x.ty, span);
    let digits = if from == Float::F32 { f32::MANTISSA_DIGITS } else { f64::MANTISSA_DIGITS };
    // One below the least value is a float only if the integer has as few bits.
    let (op, least) = match to.signed() && to.bits() > digits {
        true => (CompareOp::Ge, to.min()),
        false => (CompareOp::Gt, to.min() - 1),
    };
    let above = Expr::compare(op, x.clone(), limit(least as f64)).at(span);
    let below = Expr::compare(CompareOp::Lt, x.clone(), limit((to.max() + 1) as f64)).at(span);
    Expr::logic(LogicOp::And, above, below)
}
