//! Orders of two numbers that outlast a write, a meeting of paths, or a pass of a loop.
//!
//! * A write `x = value` keeps an order of `x` that holds for `value` before it.
//! * Where paths meet, an order holds that one path has learned and that the other proves.
//! * At the head of a loop, an order holds that holds before the loop, and that each pass preserves which begins with it.
//!
//! Must not know: the proof of an order ([`defined`](super::defined)).

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{Block, CompareOp, Expr, ExprKind, LocalId, Place, StmtKind};

use super::loops::Loop;
use super::relations::is_whole;
use super::state::{State, key};
use super::walk::passed;
use crate::passes::places::erased;
use bessemer_ir::effects::{calls, mentions, reads};
use bessemer_ir::used::Rule;

/// Largest number of locals whose orders a loop may preserve.
const LOCALS: usize = 6;
/// Largest number of orders that are tried where paths meet, and at a loop.
const TRIED: usize = 24;

/// Orders that a counted loop preserves.
#[derive(Default)]
pub(super) struct Orders {
    /// Orders at the head of a pass.
    pub(super) head: Vec<Expr>,
    /// Orders after the loop.
    pub(super) behind: Vec<Expr>,
}

impl<'m> State<'m> {
    /// Records that a place gets a value, and the facts about it.
    pub(crate) fn store(&mut self, place: &Place, value: &Expr, known: super::known::Parts) {
        let kept = self.kept(place, value);
        self.assign(place, known);
        kept.iter().for_each(|order| self.relations.learn(order));
        if place.steps.is_empty() && !calls(value) {
            self.define(place.root, value);
        }
    }

    /// Returns the orders of a local that hold for its new value, too.
    fn kept(&self, place: &Place, value: &Expr) -> Vec<Expr> {
        if !place.steps.is_empty() || value.ty.as_int().is_none() || calls(value) {
            return Vec::new();
        }
        let about = self.relations.orders_of(place.root);
        about.filter(|order| self.then(order, place.root, value)).take(TRIED).collect()
    }

    /// Returns true if an order holds after its local gets a value.
    fn then(&self, order: &Expr, local: LocalId, value: &Expr) -> bool {
        let ExprKind::Compare(op, a, b) = &order.kind else { return false };
        let (a, b) = match (is_whole(a, local), is_whole(b, local)) {
            (true, false) if !mentions(&**b, local) => (value, &**b),
            (false, true) if !mentions(&**a, local) => (&**a, value),
            _ => return false,
        };
        let holds = self.proves(&compare(*op, a, b));
        if holds {
            Rule::Kept.used();
        }
        holds
    }

    /// Returns the orders that hold here and in `other`, of which one side has not learned each.
    pub(super) fn common(&self, other: &State<'m>) -> Vec<Expr> {
        let mut common: Vec<Expr> = Vec::new();
        for (one, two) in [(self, other), (other, self)] {
            let learned = one.relations.orders_beyond(&two.relations).filter(is_plain).take(TRIED);
            common.extend(learned.filter(|order| two.proves(order)));
        }
        if !common.is_empty() {
            Rule::Met.used();
        }
        common
    }

    /// Returns the orders that a loop might preserve: those of two locals that it writes, and those of one with what
    /// it leaves.
    pub(super) fn before(&self, written: &[Place], body: &Block) -> Vec<Expr> {
        let mut locals: Vec<Expr> = Vec::new();
        for place in written {
            let local = Expr::local(place.root, &place.ty, place.span);
            let own = |stmt: &bessemer_ir::Stmt| matches!(stmt.kind, StmtKind::Let { local, .. } if local == place.root);
            if place.steps.is_empty()
                && place.ty.as_int().is_some()
                && !locals.iter().any(|it| is_whole(it, place.root))
                && !body.any_stmt(own)
            {
                locals.push(local);
            }
        }
        locals.truncate(LOCALS);
        let mut orders = Vec::new();
        for a in &locals {
            let others = locals.iter().filter(|b| b.kind != a.kind && b.ty == a.ty);
            let of_a = others.map(|b| compare(CompareOp::Le, a, b));
            orders.extend(of_a.filter(|order| self.proves(order)));
            let ExprKind::Load(place) = &a.kind else { continue };
            for b in compared_with(body, place.root, written) {
                let both = [compare(CompareOp::Le, a, &b), compare(CompareOp::Le, &b, a)];
                orders.extend(both.into_iter().filter(|order| self.proves(order)));
            }
            let beside = |order: &Expr| match &order.kind {
                ExprKind::Compare(_, x, y) if is_whole(x, place.root) => !reads(y, written),
                ExprKind::Compare(_, x, y) if is_whole(y, place.root) => !reads(x, written),
                _ => false,
            };
            orders.extend(self.relations.orders_of(place.root).filter(beside));
        }
        orders.truncate(TRIED);
        orders
    }
}

impl Loop<'_> {
    /// Returns the orders that each pass preserves, from the state before the loop and the other facts at the head of
    /// a pass.
    pub(super) fn orders<'m>(&self, before: &State<'m>, head: &State<'m>) -> Orders {
        let mut kept = before.before(self.written, self.body);
        while !kept.is_empty() {
            let mut head = head.clone();
            kept.iter().for_each(|order| head.relations.learn(order));
            let (again, left) = passed(self.body, head);
            let known = kept.len();
            kept.retain(|order| again.as_ref().is_none_or(|again| again.proves(order)));
            if kept.len() == known {
                Rule::Ordered.used();
                let everywhere = |order: &&Expr| left.iter().all(|left| left.proves(order));
                let behind = kept.iter().filter(everywhere).cloned().collect();
                return Orders { head: kept, behind };
            }
        }
        Orders::default()
    }
}

/// Returns true if an order compares two places. A computed number might fault on the path that has not learned it.
fn is_plain(order: &Expr) -> bool {
    matches!(&order.kind, ExprKind::Compare(_, a, b) if is_word(a) && is_word(b))
}

fn is_word(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Load(place) if key(place).is_some())
}

fn compare(op: CompareOp, a: &Expr, b: &Expr) -> Expr {
    Expr::compare(op, a.clone(), b.clone())
}

/// Returns the places that a body compares with a local, and does not write.
fn compared_with(body: &Block, local: LocalId, written: &[Place]) -> Vec<Expr> {
    let mut found: Vec<Expr> = Vec::new();
    body.any_expr(|expr| {
        let ExprKind::Compare(_, a, b) = &expr.kind else { return false };
        let other = if is_whole(a, local) { b } else { a };
        let is_place = is_word(other) && other.ty.as_int().is_some();
        if is_whole(a, local) != is_whole(b, local) && is_place && !reads(other, written) {
            let other = erased(other);
            if !found.contains(&other) {
                found.push(other);
            }
        }
        false
    });
    found
}
