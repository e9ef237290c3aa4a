//! Arithmetic of lengths and indices, simplified for literals.

use bessemer_ir::effects;
use bessemer_ir::{BinaryOp, CompareOp, Expr, ExprKind, Intrinsic, Span};

/// Returns the number of a literal length.
pub(super) fn number(expr: &Expr) -> Option<u64> {
    match expr.kind {
        ExprKind::Literal(word) => Some(word),
        _ => None,
    }
}

pub(super) fn is_number(expr: &Expr, wanted: u64) -> bool {
    expr.kind == ExprKind::Literal(wanted)
}

/// Returns true if two expressions are equal except for their spans.
pub(super) fn same(one: &Expr, other: &Expr) -> bool {
    match (&one.kind, &other.kind) {
        (ExprKind::Load(one), ExprKind::Load(other)) => effects::same_place(one, other),
        (ExprKind::Intrinsic(one, of), ExprKind::Intrinsic(other, by)) => {
            let all = || of.iter().zip(by).all(|(one, other)| same(one, other));
            one == other && of.len() == by.len() && all()
        }
        (one, other) => one == other,
    }
}

/// Returns a number of elements as a `usize` literal.
pub(super) fn size(number: u32, span: Span) -> Expr {
    Expr::usize(u64::from(number), span)
}

/// Returns a comparison, such as `one < other`.
pub(super) fn compared(op: CompareOp, one: &Expr, other: &Expr, span: Span) -> Expr {
    Expr::compare(op, one.clone(), other.clone()).at(span)
}

/// Returns `one + other`, simplified for literals.
pub(super) fn plus(one: Expr, other: Expr) -> Expr {
    match (&one.kind, &other.kind) {
        (ExprKind::Literal(0), _) => other,
        (_, ExprKind::Literal(0)) => one,
        (ExprKind::Literal(a), ExprKind::Literal(b)) => Expr::usize(a.saturating_add(*b), one.span),
        (ExprKind::Literal(_), _) => Expr::binary(BinaryOp::Add, other, one),
        _ => Expr::binary(BinaryOp::Add, one, other),
    }
}

/// Returns `one - other`, simplified for literals and for a common term.
pub(super) fn minus(one: Expr, other: Expr) -> Expr {
    match (&one.kind, &other.kind) {
        (_, ExprKind::Literal(0)) => one,
        (ExprKind::Literal(a), ExprKind::Literal(b)) => Expr::usize(a.saturating_sub(*b), one.span),
        (ExprKind::Binary(BinaryOp::Add, base, more), _) if same(base, &other) => (**more).clone(),
        _ => Expr::binary(BinaryOp::Sub, one, other),
    }
}

/// Returns the lesser of two lengths, as a literal if both are.
pub(super) fn least(one: Expr, other: Expr) -> Expr {
    match (number(&one), number(&other)) {
        (Some(a), Some(b)) => Expr::usize(a.min(b), one.span),
        _ => lesser(one, other),
    }
}

pub(super) fn greatest(one: Expr, other: Expr) -> Expr {
    match (number(&one), number(&other)) {
        (Some(a), Some(b)) => Expr::usize(a.max(b), one.span),
        _ => Expr::intrinsic(Intrinsic::Max, vec![one, other]),
    }
}

pub(super) fn times(one: Expr, other: Expr) -> Expr {
    Expr::binary(BinaryOp::Mul, one, other)
}

pub(super) fn divided(one: Expr, other: Expr) -> Expr {
    match (number(&one), number(&other)) {
        (Some(a), Some(b)) if b != 0 => Expr::usize(a / b, one.span),
        _ => Expr::binary(BinaryOp::Div, one, other),
    }
}

/// Returns the lesser of two lengths.
pub(super) fn lesser(length: Expr, most: Expr) -> Expr {
    Expr::intrinsic(Intrinsic::Min, vec![length, most])
}
