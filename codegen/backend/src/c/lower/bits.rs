//! Removes casts of unsigned values that have no effect, since the bits above the type are removed later.

use bessemer_ir::{BinaryOp, Expr as Ir, ExprKind, Int, Type};

use super::super::spelling::scalar_type;
use super::super::tree::Expr;
use super::place::is_small;

/// Returns true if a value is an unsigned result of bit operations or shifts.
pub(super) fn is_bits(value: &Ir) -> bool {
    let unsigned = value.ty.as_int().is_some_and(|int| !int.signed());
    let of_bits = |op: &BinaryOp| {
        use BinaryOp::{And, Or, Shl, Shr, Xor};
        matches!(op, And | Or | Xor | Shl | Shr)
    };
    unsigned && matches!(&value.kind, ExprKind::Binary(op, ..) if of_bits(op))
}

/// Returns an operand of a comparison without a redundant cast. Bits masked by a number are within their type, as are a
/// quotient and a remainder by a number.
pub(super) fn masked(value: Expr, ir: &Ir) -> Expr {
    let ExprKind::Binary(op, a, b) = &ir.kind else { return value };
    let Some(int) = ir.ty.as_int().filter(|int| !int.signed()) else { return value };
    let within = match op {
        BinaryOp::And => a.is_literal() || b.is_literal(),
        BinaryOp::Div | BinaryOp::Rem => is_small(int) && matches!(b.kind, ExprKind::Literal(_)),
        _ => false,
    };
    if within { uncast(value, &ir.ty) } else { value }
}

/// Returns true if a value is shifted to the left; C computes it in at least 32 bits.
pub(super) fn is_raised(value: &Ir) -> bool {
    is_bits(value) && matches!(value.kind, ExprKind::Binary(BinaryOp::Shl, ..))
}

/// Returns true if a value is converted from a smaller unsigned type.
pub(super) fn is_widened(value: &Ir) -> bool {
    let ExprKind::Cast(from) = &value.kind else { return false };
    matches!((from.ty.as_int(), value.ty.as_int()), (Some(from), Some(to)) if !from.signed() && fits(from, to))
}

/// Returns a value without its outermost cast to this type.
pub(super) fn uncast(value: Expr, ty: &Type) -> Expr {
    match (value, ty) {
        (Expr::Cast(to, inner), Type::Scalar(scalar)) if to == scalar_type(*scalar) => *inner,
        (value, _) => value,
    }
}

/// Returns true if one integer type contains all values of another.
pub(super) fn fits(from: Int, to: Int) -> bool {
    from.min() >= to.min() && from.max() <= to.max()
}
