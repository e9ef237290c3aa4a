//! Relations: conditions that hold, and their consequences.
//!
//! Meaning: each condition, evaluated in the state, is true and does not fault. So a condition is dropped when a
//! place that it reads is written. A consequence holds in every state that satisfies the condition. Conditions are
//! stored in a normal form ([`upright`]), so that equivalent ones look equal.

use std::collections::HashSet;
use std::rc::Rc;

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{BinaryOp, CompareOp, Expr, ExprKind, LocalId, LogicOp, Place, Span, Type};
use imbl::Vector;

use super::glance::{Glance, bit};
use crate::passes::places::erased;
use bessemer_ir::effects::{reads, same_place};

/// Largest number of disjunctions that a condition may decide. A long function has thousands.
const ALTERNATIVES: usize = 16;

/// A condition that holds, with its fingerprint.
#[derive(Clone)]
struct Relation {
    condition: Rc<Expr>,
    glance: Glance,
}

/// Conditions that hold, the latest last. A copy shares them.
#[derive(Clone, Default)]
pub(super) struct Relations(Vector<Relation>);

impl Relations {
    /// Adds a condition.
    pub(super) fn learn(&mut self, condition: &Expr) {
        let condition = Rc::new(upright(erased(condition)));
        let glance = Glance::of(&condition);
        self.0.push_back(Relation { condition, glance });
    }

    /// Adds the condition that one of two holds; the second is evaluated only where the first does not.
    pub(super) fn learn_either(&mut self, first: Expr, second: Expr) {
        let kind = ExprKind::Logic(LogicOp::Or, Box::new(first), Box::new(second));
        self.learn(&Expr { kind, ty: Type::BOOL, span: Span::default() });
    }

    /// Returns the latest disjunctions with a word of a condition. Of each, one half holds.
    pub(super) fn alternatives_about(&self, condition: &Expr) -> Vec<Rc<Expr>> {
        let mut roots = 0;
        condition.each_place(|place, _| roots |= bit(place.root));
        let is_about = |it: &&Relation| {
            it.glance.roots & roots != 0
                && matches!(it.condition.kind, ExprKind::Logic(LogicOp::Or, ..))
        };
        let about = self.0.iter().rev().filter(is_about).take(ALTERNATIVES);
        about.map(|it| Rc::clone(&it.condition)).collect()
    }

    /// Returns the number of facts.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns the expression that a local has been set to, while neither has changed.
    pub(super) fn definition(&self, local: &Expr) -> Option<&Expr> {
        let ExprKind::Load(place) = &local.kind else { return None };
        let roots = bit(place.root);
        let defines = |it: &'_ &Relation| {
            it.glance.roots & roots != 0
                && matches!(&it.condition.kind, ExprKind::Compare(CompareOp::Eq, a, _)
                    if matches!(&a.kind, ExprKind::Load(to) if same_place(to, place)))
        };
        match &self.0.iter().rev().find(defines)?.condition.kind {
            ExprKind::Compare(_, _, value) => Some(value),
            _ => None,
        }
    }

    /// Drops the conditions that read one of `written`.
    pub(super) fn forget(&mut self, written: &[Place]) {
        let roots = written.iter().fold(0, |roots, place| roots | bit(place.root));
        let reads = |it: &Relation| it.glance.roots & roots != 0 && reads(&it.condition, written);
        if self.0.iter().any(reads) {
            self.0.retain(|it| !reads(it));
        }
    }

    /// Keeps the conditions that hold here and in `other`.
    pub(super) fn join(&mut self, other: &Relations) {
        let before = self.before(other);
        let shared = other.addresses_from(before);
        let is_in_both = |it: &&Relation| {
            let mut alike = other.0.iter().filter(|other| other.glance.like(it.glance));
            shared.contains(&Rc::as_ptr(&it.condition))
                || alike.any(|other| it.condition == other.condition)
        };
        let kept: Vec<Relation> = self.0.iter().skip(before).filter(is_in_both).cloned().collect();
        if before + kept.len() < self.0.len() {
            self.0.truncate(before);
            self.0.extend(kept);
        }
    }

    /// Returns how many of the first conditions are those of `other`. Two branches share what held before them.
    fn before(&self, other: &Relations) -> usize {
        let both = self.0.iter().zip(&other.0);
        both.take_while(|(a, b)| Rc::ptr_eq(&a.condition, &b.condition)).count()
    }

    /// Returns the addresses of the conditions from a place on.
    fn addresses_from(&self, first: usize) -> HashSet<*const Expr> {
        self.0.iter().skip(first).map(|it| Rc::as_ptr(&it.condition)).collect()
    }

    /// Returns true if `condition` follows from one that holds. `fails` returns true for conditions that certainly do
    /// not hold.
    pub(super) fn give(&self, condition: &Expr, fails: impl Fn(&Expr) -> bool) -> bool {
        let condition = upright(erased(condition));
        let glance = Glance::of(&condition);
        let mut alike = self.0.iter().filter(|it| it.glance.like(glance));
        alike.any(|it| gives(&it.condition, &condition, &fails))
    }

    /// Returns the orders of a local with other numbers.
    pub(super) fn orders_of(&self, local: LocalId) -> impl Iterator<Item = Expr> {
        let about = self.0.iter().filter(move |it| it.glance.roots & bit(local) != 0);
        // Many locals share a bit.
        let is_about = move |it: &&Relation| match &it.condition.kind {
            ExprKind::Compare(_, a, b) => is_whole(a, local) || is_whole(b, local),
            _ => false,
        };
        about.rev().filter(is_about).flat_map(|it| orders(&it.condition))
    }

    /// Returns the orders of which `other` has not learned the condition, the latest first.
    pub(super) fn orders_beyond(&self, other: &Relations) -> impl Iterator<Item = Expr> {
        let before = self.before(other);
        let shared = other.addresses_from(before);
        let beyond = move |it: &&Relation| !shared.contains(&Rc::as_ptr(&it.condition));
        self.0.iter().skip(before).rev().filter(beyond).flat_map(|it| orders(&it.condition))
    }

    /// Returns each number that is known to be at least `number`, or more by the second.
    pub(super) fn above(&self, number: &Expr) -> impl Iterator<Item = (&Expr, i128)> {
        let mut roots = 0;
        number.each_place(|place, _| roots |= bit(place.root));
        let about = self.0.iter().filter(move |it| roots != 0 && it.glance.roots & roots == roots);
        about.filter_map(move |it| match &it.condition.kind {
            ExprKind::Compare(CompareOp::Lt, a, b) if **a == *number => Some((&**b, 1)),
            ExprKind::Compare(CompareOp::Le | CompareOp::Eq, a, b) if **a == *number => {
                Some((&**b, 0))
            }
            ExprKind::Compare(op @ (CompareOp::Lt | CompareOp::Le), a, b) => {
                Some((&**b, more_than(a, number)? + i128::from(*op == CompareOp::Lt)))
            }
            ExprKind::Compare(CompareOp::Eq, a, b) if **b == *number => Some((&**a, 0)),
            _ => None,
        })
    }
}

/// Returns true if an expression is the local itself.
pub(super) fn is_whole(expr: &Expr, local: LocalId) -> bool {
    matches!(&expr.kind, ExprKind::Load(place) if place.root == local && place.steps.is_empty())
}

/// Returns true if a condition that holds implies another, by itself or, for a disjunction, because its first half
/// fails.
fn gives(known: &Expr, condition: &Expr, fails: &impl Fn(&Expr) -> bool) -> bool {
    if implies(known, condition) {
        return true;
    }
    match &known.kind {
        ExprKind::Logic(LogicOp::Or, excuse, rest) => {
            fails(excuse) && gives(rest, condition, fails)
        }
        _ => false,
    }
}

/// Returns true if a condition implies another; both are in normal form.
fn implies(fact: &Expr, condition: &Expr) -> bool {
    let (ExprKind::Compare(known, x, y), ExprKind::Compare(op, a, b)) =
        (&fact.kind, &condition.kind)
    else {
        return fact == condition;
    };
    let same = x == a && y == b;
    let turned = x == b && y == a;
    match op {
        CompareOp::Le => same && matches!(known, CompareOp::Lt | CompareOp::Le),
        CompareOp::Ne => (same || turned) && matches!(known, CompareOp::Lt | CompareOp::Ne),
        _ => same && known == op,
    }
}

/// Returns the literal that a sum adds to a number, and did not overflow.
fn more_than(sum: &Expr, number: &Expr) -> Option<i128> {
    let ExprKind::Binary(BinaryOp::Add, a, b) = &sum.kind else { return None };
    let ExprKind::Literal(word) = b.kind else { return None };
    sum.ty.as_int().filter(|_| **a == *number).map(|int| int.from_word(word))
}

/// Returns the orders of two places, or of a place and a computed number, that a condition implies. What a literal
/// bounds is known as an interval.
fn orders(condition: &Expr) -> Vec<Expr> {
    let ExprKind::Compare(op, a, b) = &condition.kind else { return Vec::new() };
    if a.ty.as_int().is_none() || a.is_literal() || b.is_literal() {
        return Vec::new();
    }
    let at_most = |a: &Expr, b: &Expr| Expr::compare(CompareOp::Le, a.clone(), b.clone());
    match op {
        CompareOp::Lt => vec![condition.clone(), at_most(a, b)],
        CompareOp::Le => vec![condition.clone()],
        CompareOp::Eq => vec![at_most(a, b), at_most(b, a)],
        _ => Vec::new(),
    }
}

/// Returns a condition in normal form: comparisons use only `<`, `<=`, `==` and `!=`, and no `+ 1` that could change
/// `<` to `<=`.
fn upright(expr: Expr) -> Expr {
    let Expr { kind, ty, span } = expr;
    let kind = match kind {
        ExprKind::Compare(CompareOp::Gt, a, b) => below(*b, *a),
        ExprKind::Compare(CompareOp::Ge, a, b) => at_most(*b, *a),
        ExprKind::Compare(CompareOp::Lt, a, b) => below(*a, *b),
        ExprKind::Compare(CompareOp::Le, a, b) => at_most(*a, *b),
        ExprKind::Logic(op, a, b) => {
            ExprKind::Logic(op, Box::new(upright(*a)), Box::new(upright(*b)))
        }
        kind => kind,
    };
    Expr { kind, ty, span }
}

/// Returns `a < b`, or `a <= c` if `b` is `c + 1`.
fn below(a: Expr, b: Expr) -> ExprKind {
    match one_less(&b, BinaryOp::Add) {
        Some(b) => ExprKind::Compare(CompareOp::Le, Box::new(a), Box::new(b)),
        None => ExprKind::Compare(CompareOp::Lt, Box::new(a), Box::new(b)),
    }
}

/// Returns `a <= b`; or `a < c` if `b` is `c - 1`, or `c < b` if `a` is `c + 1`.
fn at_most(a: Expr, b: Expr) -> ExprKind {
    let (less, more) = (one_less(&a, BinaryOp::Add), one_less(&b, BinaryOp::Sub));
    let (op, a, b) = match (less, more) {
        (Some(a), _) => (CompareOp::Lt, a, b),
        (None, Some(b)) => (CompareOp::Lt, a, b),
        (None, None) => (CompareOp::Le, a, b),
    };
    ExprKind::Compare(op, Box::new(a), Box::new(b))
}

/// Returns `x` of an integer `x + 1` (or `x - 1`), which did not overflow.
fn one_less(expr: &Expr, op: BinaryOp) -> Option<Expr> {
    match &expr.kind {
        ExprKind::Binary(found, x, one) if *found == op && expr.ty.as_int().is_some() => {
            (one.kind == ExprKind::Literal(1)).then(|| (**x).clone())
        }
        _ => None,
    }
}
