//! Loops: the facts at the head of a pass, and after the loop.
//!
//! The head is reached before the first pass and after each pass, so a fact must hold both times.
//!
//! * Nothing is known about places that the body writes, except:
//! * **A counter** (`for`): its bounds do not change during the loop, and in the body it lies between them.
//! * **A local that is only counted**: every write in the body adds to it, or subtracts. Each pass moves it at most by
//!   the sum along one path, where an inner loop counts with its number of passes; so at the head of pass `k` it has
//!   moved at most `k` times that.
//! * **A word with assigned values only**: [`given`](super::given).
//! * **A loop that its body ends** has no counter, and its bounds change: an [`invariant`](super::invariant) is
//!   computed instead. Behind it holds what each `break` leaves.

use bessemer_ir::{BinaryOp, Block, CompareOp, Expr, ExprKind, LocalId, Place, Stmt, StmtKind};

use super::domain::Interval;
use super::known::Known;
use super::state::{Key, State};
use bessemer_ir::effects::{lent, overlap, whole, writes};
use bessemer_ir::used::Rule;

/// A `for` loop before its first pass.
pub(crate) struct Loop<'a> {
    /// Counter variable, as a value.
    pub(crate) counter: &'a Expr,
    pub(crate) from: &'a Expr,
    pub(crate) to: &'a Expr,
    pub(crate) inclusive: bool,
    /// True if the body ends the loop, so that its passes are not counted.
    pub(crate) ended: bool,
    /// Places that the body writes.
    pub(crate) written: &'a [Place],
    pub(crate) body: &'a Block,
}

/// A local that is only counted, with its value before the loop.
pub(super) struct Counted {
    local: Expr,
    before: Interval,
    /// Sums that a pass adds, along any part of a path.
    more: Interval,
}

impl Counted {
    /// Records its bounds after this number of passes.
    fn bound(&self, passes: i128, state: &mut State) {
        Rule::Counted.used();
        state.bound(&self.local, self.before.add(times(self.more, passes)));
    }
}

impl Loop<'_> {
    /// Changes `state` to the state at the head of a pass, and returns the state after the loop.
    pub(crate) fn enter<'m>(&self, state: &mut State<'m>) -> State<'m> {
        if self.ended {
            let head = self.invariant(state);
            let behind = self.left(head.clone());
            behind.iter().for_each(|_| Rule::Left.used());
            let behind = behind.unwrap_or_else(|| self.behind(state));
            *state = head;
            Rule::Invariant.told(!state.known.is_empty());
            return behind;
        }
        let ranges = (state.range(self.from), state.range(self.to));
        let counted = self.counted(state);
        let given = self.given(state);
        let behind = self.beyond(state, &counted, &given);
        self.head(state);
        state.known.extend(given);
        for local in counted {
            local.bound((passes(ranges, self.inclusive) - 1).max(0), state);
        }
        behind
    }

    /// Returns the state after the loop.
    pub(super) fn behind<'m>(&self, before: &State<'m>) -> State<'m> {
        match self.ended {
            true => self.beyond(before, &[], &[]),
            false => self.beyond(before, &self.counted(before), &self.given(before)),
        }
    }

    fn beyond<'m>(
        &self,
        before: &State<'m>,
        counted: &[Counted],
        given: &[(Key, Known)],
    ) -> State<'m> {
        let most = passes((before.range(self.from), before.range(self.to)), self.inclusive);
        let mut behind = before.clone();
        self.forget(&mut behind);
        behind.known.extend(given.iter().cloned());
        counted.iter().for_each(|local| local.bound(most, &mut behind));
        behind
    }

    /// Changes `state` to the state at the head of a pass, with the counter's range and without facts about written
    /// places.
    pub(super) fn head(&self, state: &mut State) {
        let ranges = (state.range(self.from), state.range(self.to));
        self.forget(state);
        Rule::Counter.used();
        let last = if self.inclusive { ranges.1.high } else { ranges.1.high.saturating_sub(1) };
        state.bound(self.counter, Interval::new(ranges.0.low, last.max(ranges.0.low)));
        let op = if self.inclusive { CompareOp::Le } else { CompareOp::Lt };
        state.assume_compare(CompareOp::Le, self.from, self.counter, true);
        state.assume_compare(op, self.counter, self.to, true);
    }

    pub(super) fn forget(&self, state: &mut State) {
        if let ExprKind::Load(place) = &self.counter.kind {
            state.forget(&[whole(place.root)]);
        }
        state.forget(self.written);
    }

    /// Returns the locals that the loop only counts, if something is known about them before.
    fn counted(&self, before: &State) -> Vec<Counted> {
        let mut head = before.clone();
        self.forget(&mut head);
        let counted = |place: &Place| {
            place.ty.as_int()?;
            let local = Expr::local(place.root, &place.ty, place.span);
            let range = before.range(&local);
            if !place.steps.is_empty() || before.all(&local.ty) == Some(range) {
                return None;
            }
            let more = increase(&self.body.0, place.root, &head)?;
            Some(Counted { local, before: range, more })
        };
        self.written.iter().filter_map(counted).collect()
    }
}

/// Returns the largest number of passes.
fn passes((from, to): (Interval, Interval), inclusive: bool) -> i128 {
    to.high.saturating_sub(from.low).saturating_add(i128::from(inclusive)).max(0)
}

/// Returns the sums that parts of a path through statements add to a local; no part adds 0. There are none if the
/// statements write it otherwise.
fn increase(stmts: &[Stmt], local: LocalId, state: &State) -> Option<Interval> {
    let of_block = |block: &Block| increase(&block.0, local, state);
    let nothing = Interval::one(0);
    let mut sum = nothing;
    for stmt in stmts {
        let added = match &stmt.kind {
            StmtKind::Assign { place, value } if place.root == local => added(place, value, state)?,
            StmtKind::If { condition, then, otherwise } if is_left(condition, local) => {
                of_block(then)?.join(of_block(otherwise)?)
            }
            StmtKind::Match { scrutinee, arms, otherwise } if is_left(scrutinee, local) => {
                let mut all = otherwise.as_ref().map_or(Some(nothing), of_block)?;
                for arm in arms {
                    all = all.join(of_block(&arm.body)?);
                }
                all
            }
            StmtKind::For { from, to, inclusive, ended: false, body, .. }
                if is_left(from, local) && is_left(to, local) =>
            {
                let passes = passes((state.range(from), state.range(to)), *inclusive);
                times(of_block(body)?, passes)
            }
            _ if writes([stmt]).iter().any(|place| overlap(place, &whole(local))) => return None,
            _ => nothing,
        };
        sum = sum.add(added.join(nothing));
    }
    Some(sum)
}

/// Returns true if the calls in an expression do not write a local.
fn is_left(expr: &Expr, local: LocalId) -> bool {
    !lent(expr).iter().any(|place| place.root == local)
}

/// Returns the sums of up to this number of passes, each with a sum in the interval.
fn times(sum: Interval, passes: i128) -> Interval {
    let end = |end: i128| end.saturating_mul(passes);
    Interval::new(end(sum.low.min(0)), end(sum.high.max(0)))
}

/// Returns the numbers that `local = local + number` adds or `local = local - number` subtracts, in a state that holds
/// throughout the loop.
fn added(place: &Place, value: &Expr, state: &State) -> Option<Interval> {
    let ExprKind::Binary(op, a, b) = &value.kind else { return None };
    let ExprKind::Load(from) = &a.kind else { return None };
    let same = place.steps.is_empty() && from.steps.is_empty() && from.root == place.root;
    if !same || b.ty.as_int().is_none() || !is_left(b, place.root) {
        return None;
    }
    match op {
        BinaryOp::Add => Some(state.range(b)),
        BinaryOp::Sub => Some(Interval::one(0).sub(state.range(b))),
        _ => None,
    }
}
