//! Orders of two numbers that each pass of a loop preserves.
//!
//! An order holds at the head of each pass if it holds before the loop, and at the end of each pass that begins with
//! it. After a counted loop, it holds if it also does wherever else the loop is left.
//!
//! Must not know: how the passes are walked ([`walk`](super::walk)).

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{Block, CompareOp, Expr, ExprKind, LocalId};

use super::knowledge::{Formula, Knowledge};
use super::linear::Linear;
use super::tracked::{End, Met, Order};
use super::values::{Point, Value, ordered};
use super::walk::{TRIALS, Walk};
use super::written::Target;
use bessemer_ir::used::Rule;

/// Largest number of locals whose orders are tracked.
const LOCALS: usize = 6;

/// Largest number of facts about a value that are tried where paths meet.
const CARRIED: usize = 8;

impl Walk<'_> {
    /// Adds the orders of two numbers that both paths show.
    pub(super) fn order(&self, mut paths: [&mut Knowledge; 2], numbers: &[Met]) {
        let numbers = &numbers[..numbers.len().min(LOCALS)];
        for (at, a) in numbers.iter().enumerate() {
            for b in numbers.iter().enumerate().filter(|(other, _)| *other != at).map(|it| it.1) {
                let at_most = |a: &Linear, b: &Linear| ordered(CompareOp::Le, a, b);
                let shown = paths.iter().zip(a.paths.iter().zip(&b.paths)).all(|(path, (a, b))| {
                    b.minus(a).is_some_and(|form| path.meets(&form, &self.values.all))
                });
                let Some(order) = at_most(&a.here, &b.here).filter(|_| shown) else { continue };
                paths.iter_mut().for_each(|path| path.assume(&order, &self.values.all));
            }
            for order in self.carried(&paths, a) {
                paths.iter_mut().for_each(|path| path.assume(&order, &self.values.all));
            }
        }
    }

    /// Returns the facts about a number's value on one path that hold of its value on the other, too.
    fn carried(&self, paths: &[&mut Knowledge; 2], number: &Met) -> Vec<Formula> {
        let mut carried = Vec::new();
        for (mine, theirs) in [(0, 1), (1, 0)] {
            let (value, other) = (&number.paths[mine], &number.paths[theirs]);
            let [(symbol, 1)] = value.parts[..] else { continue };
            for form in paths[mine].about(value).take(CARRIED) {
                let factor = form.factor(symbol);
                let of = |value: &Linear, by: i128| {
                    let rest = form.plus(-factor, &Linear::symbol(symbol))?;
                    rest.plus(factor, &value.shifted(-by)?)
                };
                let holds = of(other, value.constant)
                    .is_some_and(|form| paths[theirs].meets(&form, &self.values.all));
                carried.extend(
                    of(&number.here, value.constant).filter(|_| holds).map(Formula::Natural),
                );
            }
        }
        carried
    }

    /// Returns the orders before a loop that its passes may preserve: of two locals, and of one with its own start.
    pub(super) fn orders(
        &mut self,
        before: &Point,
        written: &[Target],
        body: &Block,
    ) -> Vec<Order> {
        if self.trials >= TRIALS {
            return Vec::new();
        }
        let mut locals: Vec<LocalId> = Vec::new();
        for target in written.iter().filter(|it| it.at.is_empty()) {
            let is_int = self.function.local(target.local).ty.as_int().is_some();
            if is_int
                && number_in(before, target.local).is_some()
                && !locals.contains(&target.local)
            {
                locals.push(target.local);
            }
        }
        locals.truncate(LOCALS);
        let mut pairs: Vec<(LocalId, LocalId)> = Vec::new();
        for a in &locals {
            pairs.extend(locals.iter().filter(|b| *b != a).map(|b| (*a, *b)));
            let beside = compared_with(body, *a).into_iter().filter(|b| !locals.contains(b));
            pairs.extend(beside.flat_map(|b| [(*a, b), (b, *a)]));
        }
        let mut orders: Vec<Order> =
            pairs.into_iter().map(|(a, b)| Order(End::Local(a), End::Local(b))).collect();
        orders.retain(|order| self.is_shown(before, order));
        for a in &locals {
            // Bounds are guessed of a number alone.
            if let Some(start) = number_in(before, *a)
                && start.as_number().is_none()
            {
                orders.push(Order(End::Local(*a), End::Start(start.clone())));
                orders.push(Order(End::Start(start.clone()), End::Local(*a)));
            }
        }
        orders
    }

    /// Returns the formula of an order at a point.
    fn formula(point: &Point, Order(low, high): &Order) -> Option<Formula> {
        let number = |end: &End| match end {
            End::Local(local) => number_in(point, *local).cloned(),
            End::Start(form) => Some(form.clone()),
        };
        ordered(CompareOp::Le, &number(low)?, &number(high)?)
    }

    pub(super) fn is_shown(&self, point: &Point, order: &Order) -> bool {
        Self::formula(point, order)
            .is_some_and(|formula| point.knowledge.shows(&formula, &self.values.all))
    }

    pub(super) fn assume_orders(&self, point: &mut Point, orders: &[Order]) {
        for order in orders {
            if let Some(formula) = Self::formula(point, order) {
                Rule::Preserved.used();
                point.knowledge.assume(&formula, &self.values.all);
            }
        }
    }
}

/// Returns the number in a local, if it is known as a form.
fn number_in(point: &Point, local: LocalId) -> Option<&Linear> {
    match point.places.get(local.0)?.iter().find(|(at, _)| at.is_empty()) {
        Some((_, Value::Number(form))) => Some(form),
        _ => None,
    }
}

/// Returns the locals with which a body compares another.
fn compared_with(body: &Block, local: LocalId) -> Vec<LocalId> {
    let whole = |expr: &Expr| match &expr.kind {
        ExprKind::Load(place) if place.steps.is_empty() => Some(place.root),
        _ => None,
    };
    let mut found = Vec::new();
    body.any_expr(|expr| {
        if let ExprKind::Compare(_, a, b) = &expr.kind
            && let (Some(a), Some(b)) = (whole(a), whole(b))
            && (a == local) != (b == local)
        {
            found.push(if a == local { b } else { a });
        }
        false
    });
    found.sort_unstable();
    found.dedup();
    found
}
