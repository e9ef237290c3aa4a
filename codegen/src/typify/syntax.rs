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

/// Whether a part of a local may be written in a block: by an assignment, or by what it is lent to. Each call on it counts.
pub(super) fn is_changed_within(block: &tree::Block, name: &str) -> bool {
    struct Changed<'n>(&'n str, bool);
    impl Changed<'_> {
        fn is_part(&self, place: &tree::Expr) -> bool {
            match &place.kind {
                tree::ExprKind::Local(name) => name == self.0,
                tree::ExprKind::Field(base, _)
                | tree::ExprKind::Index(base, _)
                | tree::ExprKind::Deref(base) => self.is_part(base),
                _ => false,
            }
        }

        fn each(&self, places: &tree::Places) -> bool {
            match places {
                tree::Places::None => false,
                tree::Places::One(place) => self.is_part(place),
                tree::Places::Each(parts) => parts.iter().any(|part| self.each(part)),
            }
        }
    }
    impl visit::Visit for Changed<'_> {
        fn expr(&mut self, expr: &tree::Expr) {
            self.1 |= match &expr.kind {
                tree::ExprKind::Assign(_, place, _) | tree::ExprKind::Ref(true, place) => {
                    self.is_part(place)
                }
                tree::ExprKind::AssignEach(places, _) => self.each(places),
                tree::ExprKind::Call(_, arguments) => {
                    arguments.first().is_some_and(|first| self.is_part(first))
                }
                _ => false,
            };
            visit::walk_expr(self, expr);
        }
    }
    let mut changed = Changed(name, false);
    visit::Visit::block(&mut changed, block);
    changed.1
}

/// The slots of the locals of a name in a function, wherever they are declared.
pub(super) fn slots_of(tree: &tree::FunctionTree, name: &str) -> Vec<u32> {
    struct Declared<'n> {
        name: &'n str,
        slots: Vec<u32>,
    }

    impl visit::Visit for Declared<'_> {
        fn stmt(&mut self, stmt: &tree::Stmt) {
            if let tree::Stmt::Let { name, slot, .. } = stmt
                && name == self.name
            {
                self.slots.push(*slot);
            }
            visit::walk_stmt(self, stmt);
        }

        fn pattern(&mut self, pattern: &tree::Pattern) {
            if let tree::Pattern::Name { name, slot, .. } = pattern
                && name == self.name
            {
                self.slots.push(*slot);
            }
            visit::walk_pattern(self, pattern);
        }
    }
    let params = tree.params.iter().filter(|it| it.name == name).map(|it| it.slot);
    let mut declared = Declared { name, slots: params.collect() };
    visit::Visit::block(&mut declared, &tree.body);
    declared.slots
}
