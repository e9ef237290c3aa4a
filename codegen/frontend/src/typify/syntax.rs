//! Properties that the author's syntax shows by itself.

use bessemer_ir::tree;
use bessemer_ir::tree::visit::Walk;

/// An expression without `&` and `*`: a reference is another name for what it refers to.
pub(super) fn bare(expr: &tree::Expr) -> &tree::Expr {
    match &expr.kind {
        tree::ExprKind::Ref(_, inner) | tree::ExprKind::Deref(inner) => bare(inner),
        _ => expr,
    }
}

/// Whether `expr` is control flow that has a value.
pub(super) fn control_with_value(expr: &tree::Expr) -> bool {
    use tree::ExprKind::{Block, If, Labelled, Match, While};
    match &expr.kind {
        Match(_, arms) => !is_question(arms),
        Labelled(..) => true,
        kind => matches!(kind, If(..) | Block(..) | While { condition: None, .. }),
    }
}

/// Whether a loop gives the value of `expr`, or of a branch of it.
pub(super) fn ends_in_loop(expr: &tree::Expr) -> bool {
    let block = |block: &tree::Block| block.tail.as_deref().is_some_and(ends_in_loop);
    match &expr.kind {
        tree::ExprKind::While { condition: None, .. } => true,
        tree::ExprKind::Block(it) => block(it),
        tree::ExprKind::If(_, then, otherwise) => {
            block(then) || otherwise.as_deref().is_some_and(ends_in_loop)
        }
        tree::ExprKind::Match(_, arms) => arms.iter().any(|arm| ends_in_loop(&arm.body)),
        _ => false,
    }
}

/// Whether the arms of a `match` are those of `matches!`.
pub(super) fn is_question(arms: &[tree::Arm]) -> bool {
    let says =
        |arm: &tree::Arm, word| matches!(arm.body.kind, tree::ExprKind::Bool(it) if it == word);
    match arms {
        [taken, rest] => {
            says(taken, true)
                && says(rest, false)
                && rest.guard.is_none()
                && matches!(rest.pattern, tree::Pattern::Any)
                && !names_by_case(&taken.pattern)
        }
        _ => false,
    }
}

/// Whether a pattern has names inside `|`, which stand for one place in one case and for another in another.
pub(super) fn names_by_case(pattern: &tree::Pattern) -> bool {
    match pattern {
        tree::Pattern::Or(cases) => cases.iter().any(|case| !case.bound().is_empty()),
        tree::Pattern::Name { inner: Some(inner), .. } => names_by_case(inner),
        tree::Pattern::Tuple(parts)
        | tree::Pattern::Array(parts)
        | tree::Pattern::Constructor(_, parts) => parts.iter().any(names_by_case),
        tree::Pattern::Fields(_, fields) => fields.iter().any(|(_, it)| names_by_case(it)),
        _ => false,
    }
}

/// Whether an expression is a variable, a part of one or, if `lent`, a reference to that, so that to name it does nothing.
pub(super) fn is_named(expr: &tree::Expr, lent: bool) -> bool {
    match &expr.kind {
        tree::ExprKind::Local(_) => true,
        tree::ExprKind::Field(base, _) | tree::ExprKind::Deref(base) => is_named(base, lent),
        tree::ExprKind::Ref(_, base) => lent && is_named(base, lent),
        _ => false,
    }
}

/// The patterns and the value of `let Some(…) = value`.
pub(super) fn some_of(condition: &tree::Expr) -> Option<(&[tree::Pattern], &tree::Expr)> {
    let tree::ExprKind::Let(pattern, value) = &condition.kind else { return None };
    match &**pattern {
        tree::Pattern::Constructor(some, parts) if some == "Some" => Some((parts, value)),
        _ => None,
    }
}

/// `..`, or `name @ ..`.
pub(super) fn is_rest(pattern: &tree::Pattern) -> bool {
    match pattern {
        tree::Pattern::Rest => true,
        tree::Pattern::Name { inner: Some(inner), .. } => matches!(**inner, tree::Pattern::Rest),
        _ => false,
    }
}

/// Whether a function gives an iterator.
pub(super) fn generates(function: &tree::Function) -> bool {
    function.tree.params.last().is_some_and(|param| param.name == tree::EACH)
}

/// Parts with the names that the fields of a tuple have.
pub(super) fn numbered(parts: &[tree::Expr]) -> Vec<(String, tree::Expr)> {
    let named = |(index, part): (usize, &tree::Expr)| (index.to_string(), part.clone());
    parts.iter().enumerate().map(named).collect()
}
