//! Properties that the author's syntax shows by itself.

use bessemer_ir::tree::{self, visit::Walk};

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
        }
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

/// The writes to a name in a block, as its syntax shows them.
pub(super) struct Writes<'n> {
    name: &'n str,
    /// Whether all of it is assigned, or lent to be.
    pub whole: bool,
    /// Whether it or a part of it may be: each call on it counts.
    pub part: bool,
}

impl<'n> Writes<'n> {
    pub(super) fn to(name: &'n str, block: &tree::Block) -> Writes<'n> {
        let mut writes = Writes { name, whole: false, part: false };
        block.each_expr(|expr| match &expr.kind {
            tree::ExprKind::Assign(_, place, _) | tree::ExprKind::Ref(true, place) => {
                writes.note(place, true);
            }
            tree::ExprKind::AssignEach(places, _) => writes.each(places),
            tree::ExprKind::Call(_, arguments) => {
                arguments.iter().take(1).for_each(|first| writes.note(first, false));
            }
            _ => {}
        });
        writes
    }

    fn note(&mut self, place: &tree::Expr, whole: bool) {
        match &place.kind {
            tree::ExprKind::Local(name) if name == self.name => {
                (self.whole, self.part) = (self.whole || whole, true);
            }
            tree::ExprKind::Field(base, _)
            | tree::ExprKind::Index(base, _)
            | tree::ExprKind::Deref(base) => self.note(base, false),
            _ => {}
        }
    }

    fn each(&mut self, places: &tree::Places) {
        match places {
            tree::Places::None => {}
            tree::Places::One(place) => self.note(place, true),
            tree::Places::Each(parts) => parts.iter().for_each(|part| self.each(part)),
        }
    }
}

/// The slots of the locals of a name in a function, wherever they are declared.
pub(super) fn slots_of(tree: &tree::FunctionTree, name: &str) -> Vec<u32> {
    let params = tree.params.iter().filter(|it| it.name == name).map(|it| it.slot);
    let mut slots: Vec<u32> = params.collect();
    tree.body.each_name(|known, slot| slots.extend((known == name).then_some(slot)));
    slots
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
