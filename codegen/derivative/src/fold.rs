//! Whole numbers that are known, and derivatives that are zero or one.
//!
//! Floats of the function are not folded, so its values keep their operations.

use bessemer_ir::{BinaryOp, CompareOp, Expr, ExprKind, Float, Scalar, Type, UnaryOp};

use crate::expression::literal;
use crate::value::Tangents;
use crate::{float, known};

fn of(value: i128, like: &Expr) -> Expr {
    Expr::literal_like(value as u64, like)
}

/// Returns `-a` or `!a` of a number that is no float.
pub fn unary(op: UnaryOp, a: Expr) -> Expr {
    let value = match (op, literal(&a), a.ty.as_int()) {
        (UnaryOp::Not, Some(value), None) => Some(1 - value),
        (UnaryOp::Neg, Some(value), Some(int)) if value != int.min() => Some(-value),
        _ => None,
    };
    match value {
        Some(value) => of(value, &a),
        None => Expr::unary(op, a),
    }
}

/// Returns an operation of two numbers that are no floats. One that faults stays.
pub fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    let (Some(left), Some(right)) = (literal(&a), literal(&b)) else {
        return Expr::binary(op, a, b);
    };
    let value = match (op, a.ty.as_int()) {
        (BinaryOp::And, _) => Some(left & right),
        (BinaryOp::Or, _) => Some(left | right),
        (BinaryOp::Xor, _) => Some(left ^ right),
        (BinaryOp::Add, Some(_)) => left.checked_add(right),
        (BinaryOp::Sub, Some(_)) => left.checked_sub(right),
        (BinaryOp::Mul, Some(_)) => left.checked_mul(right),
        (BinaryOp::Div, Some(_)) => left.checked_div(right),
        (BinaryOp::Rem, Some(_)) => left.checked_rem(right),
        _ => None,
    };
    let fits =
        |value: &i128| a.ty.as_int().is_none_or(|int| int.min() <= *value && *value <= int.max());
    match value.filter(fits) {
        Some(value) => of(value, &a),
        None => Expr::binary(op, a, b),
    }
}

/// Returns a comparison.
pub fn compare(op: CompareOp, a: Expr, b: Expr) -> Expr {
    let (Some(left), Some(right)) = (literal(&a), literal(&b)) else {
        return Expr::compare(op, a, b);
    };
    let holds = match op {
        CompareOp::Eq => left == right,
        CompareOp::Ne => left != right,
        CompareOp::Lt => left < right,
        CompareOp::Le => left <= right,
        CompareOp::Gt => left > right,
        CompareOp::Ge => left >= right,
    };
    Expr::bool(holds, a.span)
}

/// Returns `a as ty`.
pub fn cast(a: Expr, ty: &Type) -> Expr {
    let Some(value) = literal(&a) else { return a.cast(ty) };
    match *ty {
        Type::Scalar(Scalar::Int(int)) if int.min() <= value && value <= int.max() => {
            Expr::literal(value as u64, ty.clone(), a.span)
        }
        Type::Scalar(Scalar::Float(Float::F64)) => float(value as f64, ty, a.span),
        Type::Scalar(Scalar::Float(Float::F32)) => {
            let word = (value as f32).to_bits();
            Expr::literal(word.into(), ty.clone(), a.span)
        }
        _ => a.cast(ty),
    }
}

/// Returns `-a` of a derivative.
pub fn neg(a: Expr) -> Expr {
    match (known(&a), a.kind) {
        (Some(value), _) => float(-value, &a.ty, a.span),
        (None, ExprKind::Unary(UnaryOp::Neg, inner)) => *inner,
        (None, kind) => Expr::unary(UnaryOp::Neg, Expr { kind, ty: a.ty, span: a.span }),
    }
}

/// Returns `slope * a` of a derivative; none if it is zero.
fn product(slope: &Expr, a: Expr) -> Option<Expr> {
    match (known(slope), known(&a)) {
        (Some(0.0), _) | (_, Some(0.0)) => None,
        (_, Some(1.0)) => Some(slope.clone()),
        (_, Some(-1.0)) => Some(neg(slope.clone())),
        (Some(1.0), _) => Some(a),
        (Some(-1.0), _) => Some(neg(a)),
        _ => Some(Expr::binary(BinaryOp::Mul, slope.clone(), a)),
    }
}

/// Returns the derivatives times a slope.
pub fn scaled(tangents: Tangents, slope: &Expr) -> Tangents {
    let scaled = |(variable, it)| Some((variable, product(slope, it)?));
    tangents.into_iter().filter_map(scaled).collect()
}

/// Returns the derivatives of a sum.
pub fn sum(mut a: Tangents, b: Tangents) -> Tangents {
    for (variable, right) in b {
        let sum = match a.remove(&variable) {
            Some(left) => Expr::binary(BinaryOp::Add, left, right),
            None => right,
        };
        a.insert(variable, sum);
    }
    a
}

/// Returns the derivatives of a difference.
pub fn difference(mut a: Tangents, b: Tangents) -> Tangents {
    for (variable, right) in b {
        let difference = match a.remove(&variable) {
            Some(left) => Expr::binary(BinaryOp::Sub, left, right),
            None => neg(right),
        };
        a.insert(variable, difference);
    }
    a
}
