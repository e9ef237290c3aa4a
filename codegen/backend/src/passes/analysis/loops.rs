//! Loops: the facts at the head of a pass, and after the loop.
//!
//! The head is reached before the first pass and after each pass, so a fact must hold both times.
//!
//! * Nothing is known about places that the body writes, except:
//! * **A counter** (`for`): its bounds do not change during the loop, and in the body it lies between them.
//! * **A word that is only counted**, a local or a field: every write in the body adds to it, or subtracts. Each pass moves it at most by
//!   the sum along one path, where an inner loop counts with its number of passes; so at the head of pass `k` it has
//!   moved at most `k` times that.
//! * **A word with assigned values only**: [`given`](super::given).
//! * **An order of two numbers** that each pass preserves: [`orders`](super::orders).
//! * **A loop that its body ends** has no counter, and its bounds change: an [`invariant`](super::invariant) is
//!   computed instead. Behind it holds what each `break` leaves.

use bessemer_ir::{BinaryOp, Block, CompareOp, Expr, ExprKind, Intrinsic, Place, Stmt, StmtKind};

use super::domain::Interval;
use super::known::Known;
use super::state::{Key, State, key};
use bessemer_ir::effects::{lent, overlap, same_place, whole, writes};
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

/// A word that is only counted, with its value before the loop.
pub(super) struct Counted {
    /// The local, or a field of one.
    word: Expr,
    before: Interval,
    /// Sums that a pass adds, along any part of a path.
    more: Interval,
    /// The numbers of its type. A sum beyond them may wrap around.
    all: Interval,
}

impl Counted {
    /// Records its bounds after this number of passes.
    fn bound(&self, passes: i128, state: &mut State) {
        let sums = self.before.add(times(self.more, passes));
        if sums.within(self.all) {
            Rule::Counted.used();
            state.bound(&self.word, sums);
        }
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
        let before = state.clone();
        self.head(state);
        state.known.extend(given.iter().cloned());
        for local in &counted {
            local.bound((passes(ranges, self.inclusive) - 1).max(0), state);
        }
        let orders = self.orders(&before, state);
        orders.head.iter().for_each(|order| state.relations.learn(order));
        self.beyond(&before, &counted, &given, &orders.behind)
    }

    /// Returns the state after the loop.
    pub(super) fn behind<'m>(&self, before: &State<'m>) -> State<'m> {
        match self.ended {
            true => self.beyond(before, &[], &[], &[]),
            false => self.enter(&mut before.clone()),
        }
    }

    fn beyond<'m>(
        &self,
        before: &State<'m>,
        counted: &[Counted],
        given: &[(Key, Known)],
        orders: &[Expr],
    ) -> State<'m> {
        let most = passes((before.range(self.from), before.range(self.to)), self.inclusive);
        let mut behind = before.clone();
        self.forget(&mut behind);
        behind.known.extend(given.iter().cloned());
        counted.iter().for_each(|local| local.bound(most, &mut behind));
        orders.iter().for_each(|order| behind.relations.learn(order));
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
            let word = Expr {
                kind: ExprKind::Load(place.clone()),
                ty: place.ty.clone(),
                span: place.span,
            };
            let (range, all) = (before.range(&word), before.all(&word.ty)?);
            if key(place).is_none() || all == range {
                return None;
            }
            let more = increase(&self.body.0, place, &head)?;
            Some(Counted { word, before: range, more, all })
        };
        self.written.iter().filter_map(counted).collect()
    }
}

/// Returns the largest number of passes.
fn passes((from, to): (Interval, Interval), inclusive: bool) -> i128 {
    to.high.saturating_sub(from.low).saturating_add(i128::from(inclusive)).max(0)
}

/// Returns the sums that parts of a path through statements add to a word; no part adds 0. There are none if the
/// statements write it otherwise.
fn increase(stmts: &[Stmt], word: &Place, state: &State) -> Option<Interval> {
    let of_block = |block: &Block| increase(&block.0, word, state);
    let nothing = Interval::one(0);
    let mut sum = nothing;
    for stmt in stmts {
        let added = match &stmt.kind {
            StmtKind::Assign { place, value } if same_place(place, word) => {
                added(place, value, state)?
            }
            StmtKind::If { condition, then, otherwise } if is_left(condition, word) => {
                of_block(then)?.join(of_block(otherwise)?)
            }
            StmtKind::Match { scrutinee, arms, otherwise } if is_left(scrutinee, word) => {
                let mut all = otherwise.as_ref().map_or(Some(nothing), of_block)?;
                for arm in arms {
                    all = all.join(of_block(&arm.body)?);
                }
                all
            }
            StmtKind::For { from, to, inclusive, ended: false, body, .. }
                if is_left(from, word) && is_left(to, word) =>
            {
                let passes = passes((state.range(from), state.range(to)), *inclusive);
                times(of_block(body)?, passes)
            }
            _ if writes([stmt]).iter().any(|place| overlap(place, word)) => return None,
            _ => nothing,
        };
        sum = sum.add(added.join(nothing));
    }
    Some(sum)
}

/// Returns true if the calls in an expression do not write a word.
fn is_left(expr: &Expr, word: &Place) -> bool {
    !lent(expr).iter().any(|place| overlap(place, word))
}

/// Returns the sums of up to this number of passes, each with a sum in the interval.
fn times(sum: Interval, passes: i128) -> Interval {
    let end = |end: i128| end.saturating_mul(passes);
    Interval::new(end(sum.low.min(0)), end(sum.high.max(0)))
}

/// Returns the numbers that `word = word + number` adds or `word = word - number` subtracts, in a state that holds
/// throughout the loop.
fn added(place: &Place, value: &Expr, state: &State) -> Option<Interval> {
    let (adds, a, b) = match &value.kind {
        ExprKind::Binary(BinaryOp::Add, a, b) => (true, &**a, &**b),
        ExprKind::Binary(BinaryOp::Sub, a, b) => (false, &**a, &**b),
        ExprKind::Intrinsic(Intrinsic::WrappingAdd, of) => (true, of.first()?, of.get(1)?),
        ExprKind::Intrinsic(Intrinsic::WrappingSub, of) => (false, of.first()?, of.get(1)?),
        _ => return None,
    };
    let ExprKind::Load(from) = &a.kind else { return None };
    if !same_place(from, place) || b.ty.as_int().is_none() || !is_left(b, place) {
        return None;
    }
    let by = state.range(b);
    Some(if adds { by } else { Interval::one(0).sub(by) })
}
