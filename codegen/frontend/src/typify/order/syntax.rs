//! Effects of expressions, judged by the author's syntax alone: what may be evaluated later, or not at all.
//!
//! Must not know: types, and the meanings of names. A call may do anything.

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{self, Expr, ExprKind as Tree};

#[cfg(test)]
mod tests;

/// Returns the parameters of a rewritten function whose arguments are bound to names first, with these arguments. The body
/// would evaluate them in another order, or may write one while it is matched.
pub(in super::super) fn held_first<'r, 'e>(
    rule: &'r tree::FunctionTree,
    body: &Expr,
    arguments: &'e [Expr],
) -> Vec<(&'r tree::Param, &'e Expr)> {
    let (first, written) = (computed_first(body), written_in_guard(rule, body, arguments));
    let mut values: Vec<_> = rule.params.iter().zip(arguments).collect();
    let moved = |at: usize| {
        if is_followed(body, &rule.params[at].name) {
            return false;
        }
        let later = rule.params.iter().zip(arguments).skip(at + 1);
        later.filter(|(param, _)| !param.closure).any(|(_, it)| may_move(it, &arguments[at]))
    };
    let mut at = 0..;
    values.retain(|(param, argument)| {
        let moved = at.next().is_some_and(moved);
        !param.closure && (written || moved || !is_quiet(argument))
    });
    if !written && values.iter().all(|(param, _)| first.contains(&param.name.as_str())) {
        return Vec::new();
    }
    values
}

/// Returns true if a rewritten function's body follows a reference.
pub(in super::super) fn is_followed(body: &Expr, name: &str) -> bool {
    let is_it = |it: &Expr| matches!(&it.kind, Tree::Local(it) if it == name);
    body.any_expr(|it| matches!(&it.kind, Tree::Deref(inner) if is_it(inner)))
}

/// Returns true if a guard calls a closure that may write the matched value.
fn written_in_guard(rule: &tree::FunctionTree, body: &Expr, arguments: &[Expr]) -> bool {
    let Tree::Match(_, arms) = &body.kind else { return false };
    let pairs = rule.params.iter().zip(arguments);
    let is_pure_closure = |name: &String| {
        pairs.clone().any(|(param, argument)| {
            param.name == *name && matches!(&argument.kind, Tree::Closure(it) if is_pure(&it.body))
        })
    };
    let writes = |guard: &Expr| matches!(&guard.kind, Tree::Apply(f, _) if !is_pure_closure(f));
    arms.iter().filter_map(|arm| arm.guard.as_ref()).any(writes)
}

/// Returns the parameters that a body evaluates first.
fn computed_first(body: &Expr) -> Vec<&str> {
    match &body.kind {
        Tree::Match(first, _) | Tree::If(first, ..) | Tree::Unary(_, first) => {
            computed_first(first)
        }
        Tree::Tuple(parts) => parts.iter().flat_map(computed_first).collect(),
        Tree::Local(name) => vec![name],
        _ => Vec::new(),
    }
}

/// Returns true if an expression may be left unevaluated: a literal, a name, or a part of one.
pub(in super::super) fn is_plain(expr: &Expr) -> bool {
    match &expr.kind {
        Tree::Bool(_) | Tree::Int(..) | Tree::Float(..) | Tree::Bytes(_) => true,
        Tree::Local(_) | Tree::Path(..) => true,
        Tree::Constructor(_, parts) => parts.is_empty(),
        Tree::Field(inner, _) | Tree::Ref(_, inner) | Tree::Deref(inner) => is_plain(inner),
        Tree::Unary(tree::UnaryOp::Neg, inner) => {
            matches!(inner.kind, Tree::Int(..) | Tree::Float(..))
        }
        _ => false,
    }
}

/// Returns true if evaluating `later` first may change what `read` reads: it has an effect, and mentions the same
/// variable.
fn may_move(later: &Expr, read: &Expr) -> bool {
    !is_pure(later) && !later.locals().is_disjoint(&read.locals())
}

/// Returns true if an expression writes nothing, judged by its syntax; it may fault.
pub(super) fn is_pure(expr: &Expr) -> bool {
    match &expr.kind {
        Tree::Unary(_, inner) | Tree::Cast(inner) => is_pure(inner),
        Tree::Binary(_, left, right) | Tree::Index(left, right) => is_pure(left) && is_pure(right),
        _ => is_quiet(expr),
    }
}

/// Returns true if an expression writes nothing and cannot fault, judged by its syntax, so that it may be left
/// unevaluated.
fn is_quiet(expr: &Expr) -> bool {
    use tree::BinaryOp::{Eq, Ge, Gt, Le, LogicAnd, LogicOr, Lt, Ne};
    match &expr.kind {
        Tree::Binary(op, left, right) => {
            let quiet = match op {
                LogicAnd | LogicOr => true,
                // Beside a number it is no author's own operator, which may do anything.
                Eq | Ne | Lt | Le | Gt | Ge => is_number(left) || is_number(right),
                _ => false,
            };
            quiet && is_quiet(left) && is_quiet(right)
        }
        _ => is_plain(expr),
    }
}

fn is_number(expr: &Expr) -> bool {
    matches!(expr.kind, Tree::Bool(_) | Tree::Int(..) | Tree::Float(..))
}
