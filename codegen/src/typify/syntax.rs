//! Properties that the author's syntax shows by itself.

use bessemer_ir::tree;

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
        }
        _ => false,
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
