//! Invariants of loops without a counter: facts that each pass preserves.
//!
//! Passes are followed ([`walk`](super::walk)) from the state before, until nothing changes; a bound that changes is
//! dropped. One more pass then restores the bounds that every pass establishes again.

use bessemer_ir::ExprKind;

use super::domain::Interval;
use super::known::Known;
use super::loops::Loop;
use super::state::State;
use super::walk::{again, left};
use bessemer_ir::effects::whole;

impl Loop<'_> {
    /// Returns the invariant: it holds before the first pass, and each pass that begins with it ends with it.
    pub(super) fn invariant<'m>(&self, before: &State<'m>) -> State<'m> {
        let mut before = before.clone();
        if let ExprKind::Load(place) = &self.counter.kind {
            before.forget(&[whole(place.root)]);
        }
        let orders = before.before(self.written, self.body);
        orders.iter().for_each(|order| before.relations.learn(order));
        let next = |head: &State<'m>| {
            let mut next = before.clone();
            if let Some(again) = again(self.body, head.clone()) {
                next.join(&again);
            }
            next
        };
        let mut head = before.clone();
        // Each round gives up a bound of a word, a relation, or all that is left.
        while !head.widen(&next(&head)) {}
        next(&head)
    }
}

impl Loop<'_> {
    /// Returns the state behind the loop, from the state at the head of its passes; none if no `break` ends it.
    pub(super) fn left<'m>(&self, head: State<'m>) -> Option<State<'m>> {
        left(self.body, head)
    }
}

impl<'m> State<'m> {
    /// Drops each bound and each relation that `next` does not preserve; returns true if there was none.
    fn widen(&mut self, next: &State<'m>) -> bool {
        let (words, relations) = (self.known.len(), self.relations.len());
        let mut kept = true;
        self.change(next, |mine, other| match (mine, other?) {
            (Known::Within(mine), Known::Within(other)) => {
                let (low, high) = (other.low >= mine.low, other.high <= mine.high);
                kept &= low && high;
                let wider = Interval {
                    low: if low { mine.low } else { i128::MIN },
                    high: if high { mine.high } else { i128::MAX },
                };
                (low || high).then_some(Known::Within(wider))
            }
            (mine, other) => {
                let (before, after) = (mine.bounds()?, other.bounds()?);
                let wider = before.widened(after);
                kept &= wider == before;
                Known::between(wider)
            }
        });
        self.relations.join(&next.relations);
        kept && self.known.len() == words && self.relations.len() == relations
    }
}
