//! Words to which a loop only assigns values in an interval, whatever the word held before. So at the head of each
//! pass and after the loop, the word is in that interval or has its initial value. Or every pass that begins with the
//! word in an interval ends with it there: `if i > 0 { i -= 1; }`.
//!
//! Must not know: what else a loop preserves ([`loops`](super::loops)).

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{Place, StmtKind};

use super::domain::Interval;
use super::known::Known;
use super::loops::Loop;
use super::state::{Key, State, key, place_of};
use super::walk::written_in;
use bessemer_ir::effects::overlap;
use bessemer_ir::used::Rule;

impl Loop<'_> {
    /// Returns such words with their intervals, if something is known about them before.
    pub(super) fn given(&self, before: &State) -> Vec<(Key, Known)> {
        let written = |place: &Place| self.written.iter().any(|it| overlap(place, it));
        let candidates = before.known.iter().filter_map(|(key, known)| match known {
            Known::Within(interval) if written(&place_of(key)) => Some((key.clone(), *interval)),
            _ => None,
        });
        let words: Vec<(Key, Interval)> = candidates.collect();
        if words.is_empty() {
            return Vec::new();
        }
        let mut found = self.hulls(before, &words, &[]);
        let has_loops = self.body.any_stmt(|stmt| matches!(stmt.kind, StmtKind::For { .. }));
        if !has_loops {
            for (key, interval) in self.kept(before, words) {
                match found.iter_mut().find(|(other, _)| *other == key) {
                    Some((_, known)) => *known = known.meet(interval),
                    None => found.push((key, interval)),
                }
            }
        }
        let known = |(key, interval)| {
            Rule::Given.used();
            (key, Known::Within(interval))
        };
        found.into_iter().map(known).collect()
    }

    /// Returns intervals that every pass keeps which begins within all of them. They are the initial ones without the
    /// bounds that a pass moves, narrowed to the values that such passes assign.
    fn kept(&self, before: &State, words: Vec<(Key, Interval)>) -> Vec<(Key, Interval)> {
        let mut assumed = words.clone();
        loop {
            let found = self.hulls(before, &words, &assumed);
            let known = assumed.len();
            assumed.retain(|(key, _)| found.iter().any(|(other, _)| other == key));
            let mut moved = assumed.len() < known;
            for (key, interval) in &mut assumed {
                let Some((_, hull)) = found.iter().find(|(other, _)| other == key) else {
                    continue;
                };
                let (low, high) = (hull.low < interval.low, hull.high > interval.high);
                moved |= low || high;
                interval.low = if low { i128::MIN } else { interval.low };
                interval.high = if high { i128::MAX } else { interval.high };
            }
            if !moved {
                // A pass begins with the initial value, or with what one that began within all of them assigned.
                let kept = |(key, _): &(Key, Interval)| assumed.iter().any(|(it, _)| it == key);
                return found.into_iter().filter(kept).collect();
            }
        }
    }

    /// Returns the interval of each word's initial value and of the values that a pass assigns to it. Words with an
    /// unknown value are missing. The `assumed` words are in their intervals where the pass begins.
    fn hulls(
        &self,
        before: &State,
        words: &[(Key, Interval)],
        assumed: &[(Key, Interval)],
    ) -> Vec<(Key, Interval)> {
        let mut head = before.clone();
        self.head(&mut head);
        let known = |(key, interval): &(Key, Interval)| (key.clone(), Known::Within(*interval));
        head.known.extend(assumed.iter().map(known));
        let writes = written_in(self.body, head);
        let hull = |(word, start): &(Key, Interval)| {
            let at = place_of(word);
            let mut all = *start;
            for (place, parts) in writes.iter().filter(|(place, _)| overlap(place, &at)) {
                let inside = word.1.strip_prefix(&key(place)?.1[..])?;
                match parts.iter().find(|(at, _)| at == inside)? {
                    (_, Known::Within(interval)) => all = all.join(*interval),
                    (_, Known::Float(_) | Known::Between(_)) => return None,
                }
            }
            Some((word.clone(), all))
        };
        words.iter().filter_map(hull).collect()
    }
}
