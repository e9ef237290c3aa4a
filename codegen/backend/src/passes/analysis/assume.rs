//! Consequences of a condition that is true, or false.
//!
//! Meaning: executions of the state in which the condition has that truth are kept; others may be dropped. A
//! condition is assumed only after its evaluation, so it did not fault.

use bessemer_ir::{BinaryOp, CompareOp, Expr, ExprKind, Intrinsic, LogicOp, Span, Type, UnaryOp};

use super::domain::Interval;
use super::evaluate::{brought_key, is_ordered};
use super::known::Known;
use super::state::{State, key};
use crate::passes::places::erased;
use bessemer_ir::used::Rule;

impl<'m> State<'m> {
    /// Returns true if `condition` certainly holds.
    pub(crate) fn proves(&self, condition: &Expr) -> bool {
        if Rule::Interval.told(self.range(condition) == Interval::one(1)) {
            return true;
        }
        match &condition.kind {
            ExprKind::Logic(LogicOp::And, a, b) => self.proves(a) && self.proves(b),
            ExprKind::Logic(LogicOp::Or, a, b) => {
                self.holds(condition)
                    || self.proves(a)
                    || Rule::Either.told(self.assuming(a, false).proves(b))
            }
            _ => self.holds(condition) || self.by_others(&erased(condition)),
        }
    }

    /// Returns true if `condition` certainly has this truth, by intervals.
    fn is(&self, condition: &Expr, truth: bool) -> bool {
        self.range(condition) == Interval::one(i128::from(truth))
    }

    fn holds(&self, condition: &Expr) -> bool {
        Rule::Relation.told(self.relations.give(condition, |it| self.fails(it)))
    }

    /// Returns true if `condition` certainly does not hold.
    fn fails(&self, condition: &Expr) -> bool {
        self.is(condition, false)
    }

    /// Returns the state in which `condition` has the value `truth`.
    pub(crate) fn assuming(&self, condition: &Expr, truth: bool) -> State<'m> {
        let mut state = self.clone();
        state.assume(condition, truth);
        state
    }

    /// Narrows the state to executions in which `condition` is `truth`.
    pub(crate) fn assume(&mut self, condition: &Expr, truth: bool) {
        self.keep(condition, truth);
        // It may exclude one of two alternatives that were known, so that the other holds.
        for either in self.relations.alternatives_about(condition) {
            let ExprKind::Logic(LogicOp::Or, a, b) = &either.kind else { continue };
            for (one, other) in [(a, b), (b, a)] {
                if Rule::Excluded.told(self.is(one, false)) {
                    self.keep(other, true);
                }
            }
        }
    }

    fn keep(&mut self, condition: &Expr, truth: bool) {
        match &condition.kind {
            ExprKind::Unary(UnaryOp::Not, x) => self.keep(x, !truth),
            ExprKind::Logic(op, a, b) if (*op == LogicOp::And) == truth => {
                self.keep(a, truth);
                self.keep(b, truth);
                // What `b` shows may decide an alternative of `a`.
                if matches!(a.kind, ExprKind::Logic(..)) {
                    self.keep(a, truth);
                }
            }
            ExprKind::Logic(_, a, b) if self.is(a, !truth) => self.keep(b, truth),
            ExprKind::Logic(_, a, b) if self.is(b, !truth) => self.keep(a, truth),
            ExprKind::Logic(_, a, b) => {
                let half = |it: &Expr| if truth { it.clone() } else { it.clone().negated() };
                self.relations.learn_either(half(a), half(b));
            }
            ExprKind::Compare(op, a, b) => self.assume_compare(*op, a, b, truth),
            ExprKind::Load(_) => self.bound(condition, Interval::one(i128::from(truth))),
            _ if truth => self.relations.learn(condition),
            _ => {}
        }
    }

    pub(super) fn assume_compare(&mut self, op: CompareOp, a: &Expr, b: &Expr, truth: bool) {
        let float = a.ty.as_float().is_some();
        let op = match (op, truth) {
            (op, true) => op,
            (CompareOp::Eq, false) => CompareOp::Ne,
            (CompareOp::Ne, false) => CompareOp::Eq,
            (_, false) if float => return,
            (CompareOp::Lt, false) => CompareOp::Ge,
            (CompareOp::Le, false) => CompareOp::Gt,
            (CompareOp::Gt, false) => CompareOp::Le,
            (CompareOp::Ge, false) => CompareOp::Lt,
        };
        if float {
            self.order_floats(op, a, b);
        } else {
            self.order(op, a, b);
            self.assume_of_each(op, a, b);
        }
        let kind = ExprKind::Compare(op, Box::new(a.clone()), Box::new(b.clone()));
        let fact = Expr { kind, ty: Type::BOOL, span: Span::default() };
        self.relations.learn(&fact);
    }

    /// Narrows operands of a minimum or maximum. A number below the smaller of two is below each; if the larger of
    /// two is below a number, each is.
    fn assume_of_each(&mut self, op: CompareOp, a: &Expr, b: &Expr) {
        let (lower, upper, op) = match op {
            CompareOp::Lt | CompareOp::Le => (a, b, op),
            CompareOp::Gt => (b, a, CompareOp::Lt),
            CompareOp::Ge => (b, a, CompareOp::Le),
            CompareOp::Eq | CompareOp::Ne => return,
        };
        if let ExprKind::Intrinsic(Intrinsic::Max, each) = &lower.kind {
            Rule::Each.used();
            each.iter().for_each(|one| self.assume_compare(op, one, upper, true));
        }
        if let ExprKind::Intrinsic(Intrinsic::Min, each) = &upper.kind {
            Rule::Each.used();
            each.iter().for_each(|one| self.assume_compare(op, lower, one, true));
        }
    }

    /// Narrows both sides of an integer comparison that holds.
    fn order(&mut self, op: CompareOp, a: &Expr, b: &Expr) {
        if !is_ordered(op, &a.ty) {
            return;
        }
        let (x, y) = (self.range(a), self.range(b));
        let below = |high: i128| Interval::new(i128::MIN, high);
        let above = |low: i128| Interval::new(low, i128::MAX);
        match op {
            CompareOp::Lt => {
                self.bound(a, below(y.high.saturating_sub(1)));
                self.bound(b, above(x.low.saturating_add(1)));
            }
            CompareOp::Le => {
                self.bound(a, below(y.high));
                self.bound(b, above(x.low));
            }
            CompareOp::Gt => self.order(CompareOp::Lt, b, a),
            CompareOp::Ge => self.order(CompareOp::Le, b, a),
            CompareOp::Eq => {
                self.bound(a, y);
                self.bound(b, x);
            }
            // Two that are no variants may still differ.
            CompareOp::Ne if self.may_stray(a) && self.may_stray(b) => {}
            CompareOp::Ne => {
                y.single().into_iter().for_each(|value| self.bound(a, x.without(value)));
                x.single().into_iter().for_each(|value| self.bound(b, y.without(value)));
            }
        }
    }

    /// Narrows the value of `expr` to `interval`.
    pub(crate) fn bound(&mut self, expr: &Expr, interval: Interval) {
        match &expr.kind {
            ExprKind::Load(place) => {
                let (Some(key), Some(_)) = (key(place), self.all(&expr.ty)) else { return };
                let before = self.range(expr);
                let range = before.meet(interval);
                Rule::Place.told(range != before);
                self.known.insert(key, Known::Within(range));
            }
            ExprKind::Cast(x) => self.bound_number(x, interval, &expr.ty),
            ExprKind::Intrinsic(Intrinsic::Variant, args) => {
                let Some(key) = args.first().and_then(brought_key) else { return };
                Rule::Brought.used();
                let range = self.range(expr).meet(interval);
                self.known.insert(key, Known::Within(range));
            }
            // The larger of two is above the other where that one is too small.
            ExprKind::Intrinsic(Intrinsic::Max, of) if let [x, y] = of.as_slice() => {
                for (x, y) in [(x, y), (y, x)] {
                    if self.range(y).high < interval.low {
                        self.bound(x, Interval::new(interval.low, i128::MAX));
                    }
                }
            }
            ExprKind::Binary(BinaryOp::Add, a, b) => {
                Rule::Term.used();
                self.bound(a, interval.sub(self.range(b)));
                self.bound(b, interval.sub(self.range(a)));
            }
            ExprKind::Binary(BinaryOp::Sub, a, b) => {
                Rule::Term.used();
                self.bound(a, interval.add(self.range(b)));
                self.bound(b, self.range(a).sub(interval));
            }
            _ => {}
        }
    }

    /// Narrows `x`, converted to type `to`, to `interval`.
    fn bound_number(&mut self, x: &Expr, interval: Interval, to: &Type) {
        let (Some(range), Some(all)) = (self.all(&x.ty).map(|_| self.range(x)), self.all(to))
        else {
            return;
        };
        let Type::Enum(id) = x.ty else {
            if Rule::Converted.told(range.within(all)) {
                self.bound(x, interval);
            }
            return;
        };
        // Which variants have such a number; what is none of them may have any.
        let Some(definition) = self.module.enums.get(id.index()) else { return };
        let numbers =
            (0i128..).zip(&definition.variants).map(|(at, it)| (at, i128::from(it.value)));
        let may =
            numbers.filter(|(_, number)| interval.contains(*number) || !all.contains(*number));
        let stray = self.stray(&x.ty).filter(|stray| range.contains(*stray));
        let left = may.map(|(at, _)| at).filter(|at| range.contains(*at)).chain(stray);
        if let Some(left) = left.map(Interval::one).reduce(Interval::join) {
            Rule::Variant.told(left != range);
            self.bound(x, left);
        }
    }

    /// Narrows the scrutinee in the arm of a `match` for `values`. With `rest`, the arm also takes values that are no
    /// variant.
    pub(crate) fn select(&mut self, scrutinee: &Expr, values: &[i128], rest: bool) {
        let stray = self.stray(&scrutinee.ty).filter(|_| rest);
        let ones = values.iter().copied().chain(stray).map(Interval::one);
        if let Some(range) = ones.reduce(Interval::join) {
            Rule::Arm.used();
            self.bound(scrutinee, range);
        }
    }

    /// Narrows the scrutinee in the last arm of a `match`, where `values` do not occur.
    pub(crate) fn exclude(&mut self, scrutinee: &Expr, mut values: Vec<i128>) {
        Rule::Rest.used();
        values.sort_unstable();
        let range = values.iter().fold(self.range(scrutinee), |range, value| range.without(*value));
        let range = values.iter().rev().fold(range, |range, value| range.without(*value));
        self.bound(scrutinee, range);
    }
}
