//! Removes casts that have no effect: the value is within the type, or the bits above the type are removed later.

use bessemer_ir::{BinaryOp, Expr as Ir, ExprKind, Int, Module, Scalar, Type};

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

/// Returns the value that is converted twice, if the first conversion keeps every value of its type.
pub(super) fn converted_once<'a>(module: &Module, operand: &'a Ir, to: Scalar) -> Option<&'a Ir> {
    let ExprKind::Cast(inner) = &operand.kind else { return None };
    let within = operand.ty.as_int()?;
    let keeps = match (&inner.ty, to) {
        (Type::Scalar(Scalar::Int(int)), _) => fits(*int, within),
        // A number of a `bool` is unsigned (MISRA C:2012, rule 10.5).
        (Type::Scalar(Scalar::Bool), Scalar::Int(to)) => !to.signed(),
        (Type::Enum(id), _) => {
            let item = &module.enums[id.index()];
            let all = Int::min(within)..=Int::max(within);
            let numbers = item.values(0..=item.variants.len() - 1);
            numbers
                .is_some_and(|(low, high)| all.contains(&low.into()) && all.contains(&high.into()))
        }
        _ => false,
    };
    keeps.then_some(&**inner)
}

/// Returns `x & n`, `x / n` or `x % n` with the number `n` in 32 bits, for a small unsigned `x`.
pub(super) fn counted(value: &Ir) -> Option<Ir> {
    use BinaryOp::{And, Div, Rem};
    let ExprKind::Binary(op @ (And | Div | Rem), left, right) = &value.kind else { return None };
    let small = value.ty.as_int().is_some_and(|int| !int.signed() && is_small(int));
    let plain = match &left.kind {
        ExprKind::Load(_) => true,
        ExprKind::Cast(inner) => matches!(inner.kind, ExprKind::Load(_)) && is_widened(left),
        _ => false,
    };
    let number = matches!(right.kind, ExprKind::Literal(word) if word != 0 || *op == And);
    let ty = Type::Scalar(Scalar::Int(Int::U32));
    (small && plain && number).then(|| {
        let left = Ir { kind: ExprKind::Cast(left.clone()), ty: ty.clone(), span: left.span };
        let right = Ir { ty: ty.clone(), ..(**right).clone() };
        let kind = ExprKind::Binary(*op, Box::new(left), Box::new(right));
        Ir { kind, ty, span: value.span }
    })
}

/// Returns true if one integer type contains all values of another.
pub(super) fn fits(from: Int, to: Int) -> bool {
    from.min() >= to.min() && from.max() <= to.max()
}
