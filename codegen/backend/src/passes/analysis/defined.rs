//! Comparisons that follow from several others: `i < n` and `n <= length` give `i < length`.
//!
//! A local is also compared by its definition: `let end = at + 2;`, `let middle = count / 2;`. That is a relation
//! `local == value`, which holds until something that it reads is written. Integers alone: their operations did not
//! overflow.

use bessemer_ir::{BinaryOp, CompareOp, Expr, ExprKind, Intrinsic, LocalId, Place, Type};

use super::domain::Interval;
use super::state::State;
use crate::passes::places::erased;
use bessemer_ir::effects::{mentions, same_place};
use bessemer_ir::used::Rule;

/// Largest number of steps in one argument.
const DEPTH: u32 = 6;
/// Largest nesting of the number that defines a local.
const PARTS: u32 = 3;
/// Largest number of steps to the order of two ends.
const ENDS: u32 = 2;

impl State<'_> {
    /// Records what a local has just been set to.
    pub(crate) fn define(&mut self, local: LocalId, value: &Expr) {
        let defines = match &value.kind {
            ExprKind::Load(_) => true,
            ExprKind::Binary(..) if between(value)[0].is_some() => true,
            ExprKind::Binary(BinaryOp::Div, a, b) => {
                matches!(a.kind, ExprKind::Load(_)) && b.is_literal()
            }
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, ..)
            | ExprKind::Intrinsic(Intrinsic::Min | Intrinsic::Max, _) => is_composed(value, PARTS),
            ExprKind::Cast(x) => matches!(x.kind, ExprKind::Load(_)) && self.is_the_same(x, value),
            _ => false,
        };
        if defines && value.ty.as_int().is_some() && !mentions(value, local) {
            let local = Expr::local(local, &value.ty, value.span);
            self.assume_compare(CompareOp::Eq, &local, value, true);
        }
    }

    /// Returns true if a comparison follows from others.
    pub(super) fn by_others(&self, condition: &Expr) -> bool {
        let ExprKind::Compare(op, a, b) = &condition.kind else { return false };
        if a.ty.as_int().is_none() {
            return false;
        }
        let holds = match op {
            CompareOp::Le => self.at_most(a, b, 0, DEPTH),
            CompareOp::Lt => self.at_most(a, b, -1, DEPTH),
            CompareOp::Ge => self.at_most(b, a, 0, DEPTH),
            CompareOp::Gt => self.at_most(b, a, -1, DEPTH),
            CompareOp::Ne => self.unequal(a, b, DEPTH),
            CompareOp::Eq => false,
        };
        if holds {
            Rule::Others.used();
        }
        holds
    }

    /// Returns true if a conversion keeps the number.
    fn is_the_same(&self, x: &Expr, converted: &Expr) -> bool {
        let (from, to) = (x.ty.as_int(), self.all(&converted.ty));
        from.is_some() && to.is_some_and(|to| self.range(x).within(to))
    }

    /// Returns true if `a != b` for a number `b`, since what `a` comes from is another.
    fn unequal(&self, a: &Expr, b: &Expr, depth: u32) -> bool {
        let (Some(depth), Some(number)) = (depth.checked_sub(1), self.range(b).single()) else {
            return false;
        };
        match &a.kind {
            ExprKind::Load(_) => {
                self.relations.definition(a).is_some_and(|a| self.unequal(a, b, depth))
            }
            ExprKind::Cast(x) if self.is_the_same(x, a) => {
                let Some(int) = x.ty.as_int() else { return false };
                if number < int.min() || int.max() < number {
                    return true;
                }
                let word = ExprKind::Literal(number as u64);
                let number = Expr { kind: word, ty: x.ty.clone(), span: b.span };
                let kind = ExprKind::Compare(CompareOp::Ne, x.clone(), Box::new(number));
                self.proves(&Expr { kind, ty: Type::BOOL, span: b.span })
            }
            _ => false,
        }
    }

    /// Returns true if `a <= b + more`.
    fn at_most(&self, a: &Expr, b: &Expr, more: i128, depth: u32) -> bool {
        if a == b && more >= 0 {
            return true;
        }
        let (from, to) = (self.range(a), self.range(b));
        if from.high <= to.low.saturating_add(more) {
            return true;
        }
        let Some(depth) = depth.checked_sub(1) else { return false };
        let number = |it: &Expr| self.range(it).single();
        let unsigned = a.ty.as_int().is_some_and(|int| !int.signed());
        let of_a = match &a.kind {
            ExprKind::Binary(BinaryOp::Add, x, by) => match number(by) {
                Some(by) => self.at_most(x, b, more.saturating_sub(by), depth),
                None if let Some(of) = number(x) => {
                    self.at_most(by, b, more.saturating_sub(of), depth)
                }
                None => {
                    self.sum_at_most((x, by), b, more, depth)
                        || self.sum_at_most((by, x), b, more, depth)
                }
            },
            ExprKind::Binary(BinaryOp::Sub, x, by) => match number(by) {
                Some(by) => self.at_most(x, b, more.saturating_add(by), depth),
                None => self.range(by).low >= 0 && self.at_most(x, b, more, depth),
            },
            ExprKind::Binary(BinaryOp::Div, x, by) if unsigned => {
                number(by).is_some_and(|by| by > 0) && self.at_most(x, b, more, depth)
            }
            ExprKind::Intrinsic(Intrinsic::Min, all) => {
                all.iter().any(|x| self.at_most(x, b, more, depth))
            }
            ExprKind::Intrinsic(Intrinsic::Max, all) => {
                all.iter().all(|x| self.at_most(x, b, more, depth))
            }
            _ => false,
        };
        let halved = || between(a).into_iter().flatten();
        let of_a = of_a || halved().any(|ends| self.between_at_most(ends, b, more, depth));
        let of_b = || match &b.kind {
            ExprKind::Binary(BinaryOp::Add, y, by) => {
                self.at_most(a, y, more.saturating_add(self.range(by).low), depth)
            }
            ExprKind::Binary(BinaryOp::Sub, y, by) => match number(by) {
                Some(by) => self.at_most(a, y, more.saturating_sub(by), depth),
                None => self.sum_at_most((a, by), y, more, depth),
            },
            ExprKind::Intrinsic(Intrinsic::Max, all) => {
                all.iter().any(|y| self.at_most(a, y, more, depth))
            }
            ExprKind::Intrinsic(Intrinsic::Min, all) => {
                all.iter().all(|y| self.at_most(a, y, more, depth))
            }
            _ => self.relations.definition(b).is_some_and(|b| self.at_most(a, b, more, depth)),
        } || between(b).into_iter().flatten().any(|(x, y)| {
            self.at_most(x, y, 0, depth) && self.at_most(a, x, more, depth)
        });
        let above = |(c, less): (&Expr, i128)| self.at_most(c, b, more.saturating_add(less), depth);
        of_a || of_b() || self.relations.above(a).any(above)
    }

    /// Returns true if a number between `x` and `y`, and below `y` if `x` is, is at most `b + more`.
    fn between_at_most(&self, (x, y): (&Expr, &Expr), b: &Expr, more: i128, depth: u32) -> bool {
        self.at_most(x, y, -1, depth) && self.at_most(y, b, more.saturating_add(1), depth)
            || self.at_most(x, y, 0, depth) && self.at_most(y, b, more, depth)
    }

    /// Returns the interval of a number between two others, if an expression is such.
    pub(crate) fn halved(&self, expr: &Expr) -> Option<Interval> {
        if self.blind {
            return None;
        }
        let narrowed = |(x, y): (&Expr, &Expr)| {
            let (low, high) = (self.range(x), self.range(y));
            match self.at_most(&erased(x), &erased(y), -1, ENDS) {
                true => Interval::new(low.low, high.high.saturating_sub(1).max(low.low)),
                false => low.join(high),
            }
        };
        between(expr).into_iter().flatten().map(narrowed).reduce(Interval::meet)
    }

    /// Returns true if `x + y <= b + more`, where `y` is at most a difference `z - x`. The sum itself may be beyond its
    /// type.
    fn sum_at_most(&self, (x, y): (&Expr, &Expr), b: &Expr, more: i128, depth: u32) -> bool {
        let (of_x, of_y) = (self.range(x).high, self.range(y).high);
        if of_x.saturating_add(of_y) <= self.range(b).low.saturating_add(more) {
            return true;
        }
        let Some(depth) = depth.checked_sub(1) else { return false };
        let is_rest = |c: &Expr, less: i128| match &c.kind {
            ExprKind::Binary(BinaryOp::Sub, z, of) if **of == *x => {
                self.at_most(z, b, more.saturating_add(less), depth)
            }
            _ => false,
        };
        let is_below_a_rest = |defined: &Expr| match &defined.kind {
            ExprKind::Intrinsic(Intrinsic::Min, all) => all.iter().any(|c| is_rest(c, 0)),
            _ => false,
        };
        self.relations.definition(y).is_some_and(is_below_a_rest)
            || self.relations.above(y).any(|(c, less)| {
                is_rest(c, less) || self.relations.definition(c).is_some_and(|c| is_rest(c, less))
            })
    }

    /// Returns the difference of two numbers, if one of them is defined by the other and a literal.
    pub(super) fn difference(&self, a: &Expr, b: &Expr) -> Option<i128> {
        let (ExprKind::Load(left), ExprKind::Load(right)) = (&a.kind, &b.kind) else { return None };
        let beyond = |whole: &Expr, of: &Place| {
            let ExprKind::Binary(op, part, by) = &self.relations.definition(whole)?.kind else {
                return None;
            };
            let same = matches!(&part.kind, ExprKind::Load(part) if same_place(part, of));
            let by = self.range(by).single().filter(|_| same)?;
            match op {
                BinaryOp::Add => Some(by),
                BinaryOp::Sub => Some(-by),
                _ => None,
            }
        };
        beyond(a, right).or_else(|| beyond(b, left).map(|by| -by))
    }
}

/// Returns true if a number is made of places and literals by sums, differences, minima and maxima, nested to a depth.
fn is_composed(expr: &Expr, depth: u32) -> bool {
    let inside = depth.saturating_sub(1);
    match &expr.kind {
        ExprKind::Load(_) => true,
        ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) if depth > 0 => {
            is_composed(a, inside) && is_composed(b, inside)
        }
        ExprKind::Intrinsic(Intrinsic::Min | Intrinsic::Max, all) if depth > 0 => {
            all.iter().all(|it| is_composed(it, inside))
        }
        _ => expr.is_literal(),
    }
}

/// Returns the ends between which half of a difference or of a sum of natural numbers is.
///
/// They are those of `x + (y - x) / 2`, the lower first, and of `(x + y) / 2` in either order. The number is below the
/// higher if they are not equal.
fn between(expr: &Expr) -> [Option<(&Expr, &Expr)>; 2] {
    if expr.ty.as_int().is_none_or(|int| int.signed()) {
        return [None, None];
    }
    let same = |a: &Expr, b: &Expr| match (&a.kind, &b.kind) {
        (ExprKind::Load(a), ExprKind::Load(b)) => same_place(a, b),
        _ => false,
    };
    let is_place = |it: &Expr| matches!(it.kind, ExprKind::Load(_));
    let halved = |it: &Expr| match &it.kind {
        ExprKind::Binary(BinaryOp::Div, _, by) => by.kind == ExprKind::Literal(2),
        ExprKind::Binary(BinaryOp::Shr, _, by) => by.kind == ExprKind::Literal(1),
        _ => false,
    };
    match &expr.kind {
        ExprKind::Binary(BinaryOp::Add, x, part) if halved(part) => {
            let ExprKind::Binary(_, rest, _) = &part.kind else { return [None, None] };
            let ExprKind::Binary(BinaryOp::Sub, y, from) = &rest.kind else { return [None, None] };
            [same(x, from).then_some((&**x, &**y)), None]
        }
        ExprKind::Binary(_, sum, _) if halved(expr) => {
            let ExprKind::Binary(BinaryOp::Add, x, y) = &sum.kind else { return [None, None] };
            let places = is_place(x) && is_place(y);
            [places.then_some((&**x, &**y)), places.then_some((&**y, &**x))]
        }
        _ => [None, None],
    }
}
