//! Finds comparisons in a condition: pairs of numbers of which one is less than the other while it is true.
//!
//! Looks at one condition only; [`termination`](super) follows how the numbers move.

use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Intrinsic, LogicOp, Module, Place, Step, Stmt, StmtKind,
    UnaryOp,
};

use bessemer_ir::effects::{reads, same_place, writes};

/// Returns the comparisons `low < high` that must be true for a condition to be `truth`, and their consequences. The
/// condition follows the statements `before`. Example: `i + 2 < n` is false if `i < n` is, and so is `i < n - 2`.
/// Consequences come first, since the loop counts in them.
pub(super) fn bounds<'e>(
    module: &Module,
    before: &'e [Stmt],
    condition: &'e Expr,
    truth: bool,
) -> Vec<(&'e Expr, &'e Expr, bool)> {
    let meant = |number| meant(before, number);
    let compared: Vec<_> = comparisons(condition, truth)
        .into_iter()
        .map(|(low, high, inclusive)| (meant(low), meant(high), inclusive))
        .collect();
    let follow = compared.iter().flat_map(|&(low, high, inclusive)| {
        let below = no_more(module, low).into_iter().map(move |low| (low, high, inclusive));
        let above = no_less(module, high).into_iter().map(move |high| (low, high, inclusive));
        below.chain(above)
    });
    follow.chain(compared.iter().copied()).collect()
}

/// Returns the value of an expression that the statements `before` the condition name and leave unchanged.
pub(super) fn meant<'e>(before: &'e [Stmt], expr: &'e Expr) -> &'e Expr {
    let Some(name) = place(expr).filter(|place| place.steps.is_empty()) else { return expr };
    let declares =
        |stmt: &Stmt| matches!(&stmt.kind, StmtKind::Let { local, .. } if *local == name.root);
    let Some(at) = before.iter().rposition(declares) else { return expr };
    let StmtKind::Let { value: Some(value), .. } = &before[at].kind else { return expr };
    let since = writes(&before[at + 1..]);
    let stays = place(value).is_some() && !reads(value, &since) && !reads(expr, &since);
    if stays { value } else { expr }
}

/// Returns the parts of a number that cannot exceed it: `i` of `i + 2`, of `3 * i` and of `i * i`.
fn no_more<'e>(module: &Module, expr: &'e Expr) -> Vec<&'e Expr> {
    let ExprKind::Binary(op, a, b) = &expr.kind else { return Vec::new() };
    let least = |part: &Expr| shown_least(module, part).unwrap_or(-1);
    let is_square = || place(a).zip(place(b)).is_some_and(|(a, b)| same_place(a, b));
    let holds = |part: &Expr, other: &Expr| match op {
        BinaryOp::Add => least(other) >= 0,
        BinaryOp::Mul => least(part) >= 0 && (least(other) >= 1 || is_square()),
        _ => false,
    };
    [(a, b), (b, a)]
        .into_iter()
        .filter(|(part, other)| holds(part, other))
        .map(|(part, _)| &**part)
        .collect()
}

/// Returns the part of a number that cannot be less than it: `n` of `n - 2`.
fn no_less<'e>(module: &Module, expr: &'e Expr) -> Option<&'e Expr> {
    let ExprKind::Binary(BinaryOp::Sub, whole, less) = &expr.kind else { return None };
    shown_least(module, less).is_some_and(|least| least >= 0).then_some(whole)
}

/// Returns the comparisons `low < high` that must hold for a condition to be `truth`.
fn comparisons(condition: &Expr, truth: bool) -> Vec<(&Expr, &Expr, bool)> {
    match &condition.kind {
        ExprKind::Unary(UnaryOp::Not, inner) => comparisons(inner, !truth),
        ExprKind::Logic(op, a, b) if (*op == LogicOp::And) == truth => {
            let mut all = comparisons(a, truth);
            all.extend(comparisons(b, truth));
            all
        }
        ExprKind::Compare(op, a, b) if a.ty.as_int().is_some() => match (op, truth) {
            (CompareOp::Lt, true) | (CompareOp::Ge, false) => vec![(&**a, &**b, false)],
            (CompareOp::Le, true) | (CompareOp::Gt, false) => vec![(a, b, true)],
            (CompareOp::Gt, true) | (CompareOp::Le, false) => vec![(b, a, false)],
            (CompareOp::Ge, true) | (CompareOp::Lt, false) => vec![(b, a, true)],
            // What is not 0 is above it, if there is nothing below.
            (CompareOp::Ne, true) | (CompareOp::Eq, false) if is_unsigned(a) => {
                match (&a.kind, &b.kind) {
                    (_, ExprKind::Literal(0)) => vec![(b, a, false)],
                    (ExprKind::Literal(0), _) => vec![(a, b, false)],
                    _ => Vec::new(),
                }
            }
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

pub(super) fn shown_least(module: &Module, expr: &Expr) -> Option<i128> {
    let int = expr.ty.as_int()?;
    let least = |part| shown_least(module, part);
    let shown = match &expr.kind {
        ExprKind::Literal(word) => Some(int.from_word(*word)),
        ExprKind::Const(id) => {
            module.consts[id.index()].words.first().map(|word| int.from_word(*word))
        }
        ExprKind::Cast(inner) if is_unsigned(inner) && is_unsigned(expr) => {
            let from = inner.ty.as_int()?;
            least(inner).filter(|_| from.bits() <= int.bits())
        }
        ExprKind::Binary(BinaryOp::Add, a, b) => least(a).zip(least(b)).map(|(a, b)| a + b),
        ExprKind::Intrinsic(Intrinsic::Max, parts) => parts.iter().filter_map(least).max(),
        _ => None,
    };
    shown.or(is_unsigned(expr).then_some(0))
}

pub(super) fn is_unsigned(expr: &Expr) -> bool {
    expr.ty.as_int().is_some_and(|int| !int.signed())
}

/// Returns the place that an expression loads, if only fields lead to it.
pub(super) fn place(expr: &Expr) -> Option<&Place> {
    match &expr.kind {
        ExprKind::Load(place) => {
            let fields = place.steps.iter().all(|step| matches!(step, Step::Field(_)));
            fields.then_some(place)
        }
        _ => None,
    }
}
