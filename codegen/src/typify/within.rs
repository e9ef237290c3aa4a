//! Whether a value lies between two others.

use bessemer_ir::{CompareOp, Expr, LogicOp, Span, Type, UnaryOp};

/// `low <= value && value <= high`, or what is left of it.
pub(super) fn test(value: &Expr, (low, high): (i128, i128), span: Span) -> Expr {
    if value.ty == Type::BOOL {
        let not = Expr::unary(UnaryOp::Not, value.clone()).at(span);
        return if low == 1 { value.clone() } else { not };
    }
    let compare = |op, limit: i128| {
        Expr::compare(op, value.clone(), Expr::literal_like(limit as u64, value)).at(span)
    };
    let (least, most) = value.ty.as_int().map_or((-1, i128::MAX), |int| (int.min(), int.max()));
    match (low == least, high == most) {
        _ if low == high => compare(CompareOp::Eq, low),
        (true, true) => Expr::bool(true, span),
        (true, false) => compare(CompareOp::Le, high),
        (false, true) => compare(CompareOp::Ge, low),
        (false, false) => {
            let (above, below) = (compare(CompareOp::Ge, low), compare(CompareOp::Le, high));
            Expr::logic(LogicOp::And, above, below)
        }
    }
}
