//! Words that each pass of a counted loop moves by a bounded amount.
//!
//! A pass that begins with a word at `start` ends with it between `start + down` and `start + up`, and so does one that is left
//! on its way. A field is followed only from numbers far from the ends of its type, since a sum there may wrap around; so
//! all its passes must remain among them.
//!
//! Must not know: what else a loop preserves ([`orders`](super::orders), and guessed bounds).

use bessemer_ir::{Block, Step, Type};

use super::tracked::{Moved, number_at, put};
use super::values::{Point, Value, step_type, within};
use super::walk::Walk;
use super::written::Target;

/// Largest movement in a pass that is tracked.
const FAST: i128 = 1 << 32;

impl Walk<'_> {
    /// Returns the words that a pass moves by a bounded amount, in a loop of at most `most` passes.
    pub(super) fn moved(
        &mut self,
        before: &Point,
        head: &Point,
        written: &[Target],
        most: i128,
        body: &Block,
    ) -> Vec<Moved> {
        let mut words: Vec<&Target> = Vec::new();
        for word in written {
            let is_int = self.type_at(word).is_some_and(|ty| ty.as_int().is_some());
            let same = |it: &&Target| it.local == word.local && it.at == word.at;
            if is_int && !words.iter().any(same) {
                words.push(word);
            }
        }
        words.sort_by_key(|word| word.local);
        // What one field's start admits may count for the others, so each must hold, or the trial is not used.
        loop {
            let (found, failed) = self.movements(before, head, &words, most, body);
            if failed.is_empty() {
                return found;
            }
            words.retain(|word| !failed.contains(word));
        }
    }

    /// Returns the movements of words in a pass, and the fields that may leave the numbers at which it begins.
    fn movements<'t>(
        &mut self,
        before: &Point,
        head: &Point,
        words: &[&'t Target],
        most: i128,
        body: &Block,
    ) -> (Vec<Moved>, Vec<&'t Target>) {
        let (mut trial, mut begun) = (head.clone(), Vec::new());
        for word in words.iter().copied() {
            let Some(old) = number_at(before, word).cloned() else { continue };
            let Some(Value::Number(start)) = self.unknown_at(word) else { continue };
            let (low, high) = self.values.range(&trial, &start);
            let far = if word.at.is_empty() { (low, high) } else { (low / 2, high / 2) };
            if let Some(within) = within(&start, far) {
                trial.knowledge.assume(&within, &self.values.all);
            }
            put(&mut trial, word, start.clone());
            begun.push((word, old, start, far));
        }
        if begun.is_empty() {
            return (Vec::new(), Vec::new());
        }
        let (again, left) = self.trial(body, trial);
        let (mut found, mut failed) = (Vec::new(), Vec::new());
        for (word, old, start, far) in begun {
            let mut by = (0, 0);
            for point in again.iter().chain(&left) {
                let more = number_at(point, word).and_then(|now| now.minus(&start));
                let more = more.map(|it| point.knowledge.closest(&it, &self.values.all));
                let (low, high) = more.unwrap_or((i128::MIN, i128::MAX));
                by = (low.min(by.0), high.max(by.1));
            }
            let slow = by.0.checked_abs().is_some_and(|by| by < FAST) && by.1 < FAST;
            let (low, high) = before.knowledge.range(&old, &self.values.all);
            let reached = |from: i128, by: i128| {
                by.checked_mul(most.max(0)).and_then(|by| from.checked_add(by))
            };
            let remains = || {
                reached(low, by.0).is_some_and(|least| far.0 <= least)
                    && reached(high, by.1).is_some_and(|greatest| greatest <= far.1)
            };
            if slow && (word.at.is_empty() || remains()) {
                let word = Target { local: word.local, at: word.at.clone() };
                found.push(Moved { word, old, by });
            } else if !word.at.is_empty() {
                failed.push(word);
            }
        }
        (found, failed)
    }

    /// Returns the type of a word that fields lead to.
    fn type_at(&self, word: &Target) -> Option<Type> {
        let ty = self.function.local(word.local).ty.clone();
        word.at.iter().try_fold(ty, |ty, step| {
            step_type(self.values.module, &ty, &Step::Field(step.field()?))
        })
    }

    /// Returns an unknown value of such a word's type.
    pub(super) fn unknown_at(&mut self, word: &Target) -> Option<Value> {
        let ty = self.type_at(word)?;
        self.values.unknown(&ty)
    }
}
