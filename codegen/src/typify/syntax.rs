//! Properties that the author's syntax shows by itself.

use bessemer_ir::tree::{self, visit};

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

/// Whether a name is assigned in a block, or lent to be.
pub(super) fn is_rebound(block: &tree::Block, name: &str) -> bool {
    struct Written<'n>(&'n str, bool);
    impl Written<'_> {
        fn note(&mut self, place: &tree::Expr) {
            self.1 |= matches!(&place.kind, tree::ExprKind::Local(name) if name == self.0);
        }

        fn each(&mut self, places: &tree::Places) {
            match places {
                tree::Places::None => {}
                tree::Places::One(place) => self.note(place),
                tree::Places::Each(parts) => parts.iter().for_each(|part| self.each(part)),
            }
        }
    }
    impl visit::Visit for Written<'_> {
        fn expr(&mut self, expr: &tree::Expr) {
            match &expr.kind {
                tree::ExprKind::Assign(None, place, _) | tree::ExprKind::Ref(true, place) => {
                    self.note(place);
                }
                tree::ExprKind::AssignEach(places, _) => self.each(places),
                _ => {}
            }
            visit::walk_expr(self, expr);
        }
    }
    let mut written = Written(name, false);
    visit::Visit::block(&mut written, block);
    written.1
}
