//! Properties of the author's expressions that their syntax shows.

use bessemer_ir::tree;
use bessemer_ir::tree::visit::{VisitMut, Walk, walk_pattern_mut};

/// Returns an expression without its outer `&` and `*`, since a reference is an alias of its referent.
pub(super) fn bare(expr: &tree::Expr) -> &tree::Expr {
    match &expr.kind {
        tree::ExprKind::Ref(_, inner) | tree::ExprKind::Deref(inner) => bare(inner),
        _ => expr,
    }
}

/// Returns true if `expr` is control flow that has a value.
pub(super) fn control_with_value(expr: &tree::Expr) -> bool {
    use tree::ExprKind::{Block, If, Labelled, Match, While};
    match &expr.kind {
        Match(_, arms) => !is_question(arms),
        Labelled(..) => true,
        kind => matches!(kind, If(..) | Block(..) | While { condition: None, .. }),
    }
}

/// Returns true if a loop computes the value of `expr`, or of a branch of it.
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

/// Returns true if the arms of a `match` are those of `matches!`.
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

/// Returns true if a pattern binds names inside `|`, which denote different places in different cases.
pub(super) fn names_by_case(pattern: &tree::Pattern) -> bool {
    with_case(pattern, 0).1 > 0
}

/// Returns the alternatives of a pattern with names inside `|`, in the order in which Rust tests them.
pub(super) fn alternatives(pattern: &tree::Pattern) -> Vec<tree::Pattern> {
    match with_case(pattern, 0) {
        (whole, 0) => vec![whole],
        (_, count) => {
            (0..count).flat_map(|case| alternatives(&with_case(pattern, case).0)).collect()
        }
    }
}

/// Replaces the first `|` with names in it by its alternative `case`, and returns the pattern and the number of
/// alternatives.
fn with_case(pattern: &tree::Pattern, case: usize) -> (tree::Pattern, usize) {
    let (mut whole, mut cases) = (pattern.clone(), Cases { case, count: 0 });
    cases.pattern(&mut whole);
    (whole, cases.count)
}

/// Visitor that replaces the first `|` with names in it by one alternative, and counts the alternatives.
struct Cases {
    case: usize,
    count: usize,
}

impl VisitMut for Cases {
    fn pattern(&mut self, pattern: &mut tree::Pattern) {
        match pattern {
            _ if self.count > 0 => {}
            tree::Pattern::Or(cases) if cases.iter().any(|it| !it.bound().is_empty()) => {
                self.count = cases.len();
                *pattern = cases.swap_remove(self.case);
            }
            _ => walk_pattern_mut(self, pattern),
        }
    }
}

/// Returns true if naming an expression has no effect. It is a variable, a part of one or, if `lent`, a reference to
/// that.
pub(super) fn is_named(expr: &tree::Expr, lent: bool) -> bool {
    match &expr.kind {
        tree::ExprKind::Local(_) => true,
        tree::ExprKind::Field(base, _) | tree::ExprKind::Deref(base) => is_named(base, lent),
        tree::ExprKind::Ref(_, base) => lent && is_named(base, lent),
        _ => false,
    }
}

/// Returns `if let pattern` as the arms of a `match`.
pub(super) fn either(
    pattern: &tree::Pattern,
    then: &tree::Block,
    otherwise: Option<&tree::Expr>,
    site: tree::Site,
) -> [tree::Arm; 2] {
    let plain = |block| tree::Expr { kind: tree::ExprKind::Block(block), site, slot: None };
    let arm = |pattern, body| tree::Arm { pattern, guard: None, body, site };
    let rest = otherwise.cloned().unwrap_or_else(|| plain(tree::Block::default()));
    [arm(pattern.clone(), plain(then.clone())), arm(tree::Pattern::Any, rest)]
}

/// Returns the patterns and the value of `let Some(…) = value`.
pub(super) fn some_of(condition: &tree::Expr) -> Option<(&[tree::Pattern], &tree::Expr)> {
    let tree::ExprKind::Let(pattern, value) = &condition.kind else { return None };
    match &**pattern {
        tree::Pattern::Constructor(some, parts) if some == "Some" => Some((parts, value)),
        _ => None,
    }
}

/// Returns true for `..` and `name @ ..`.
pub(super) fn is_rest(pattern: &tree::Pattern) -> bool {
    match pattern {
        tree::Pattern::Rest => true,
        tree::Pattern::Name { inner: Some(inner), .. } => matches!(**inner, tree::Pattern::Rest),
        _ => false,
    }
}

/// Returns true if a function returns an iterator.
pub(super) fn generates(function: &tree::Function) -> bool {
    function.tree.params.last().is_some_and(|param| param.name == tree::EACH)
}

/// Returns true if a function is one of the DSL's own.
pub(super) fn is_of_library(function: &tree::Function) -> bool {
    function.module.starts_with("bessemer::")
}

/// Returns parts with the field names of a tuple.
pub(super) fn numbered(parts: &[tree::Expr]) -> Vec<(String, tree::Expr)> {
    let named = |(index, part): (usize, &tree::Expr)| (index.to_string(), part.clone());
    parts.iter().enumerate().map(named).collect()
}
