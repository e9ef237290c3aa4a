//! Words to which a loop only assigns values in an interval, whatever the word held before. So at the head of each
//! pass and after the loop, the word is in that interval or has its initial value.
//!
//! Must not know: what else a loop preserves ([`loops`](super::loops)).

use bessemer_ir::Place;

use super::domain::Interval;
use super::known::Known;
use super::loops::{Counted, Loop};
use super::state::{Key, State, key, place_of};
use super::walk::written_in;
use bessemer_ir::effects::overlap;
use bessemer_ir::used::Rule;

impl Loop<'_> {
    /// Returns such words with their intervals, if something is known about them before; except counted ones, of
    /// which more is known.
    pub(super) fn given(&self, before: &State, counted: &[Counted]) -> Vec<(Key, Known)> {
        let counts = |key: &Key| counted.iter().any(|it| it.key().as_ref() == Some(key));
        let written = |place: &Place| self.written.iter().any(|it| overlap(place, it));
        let candidates = before.known.iter().filter_map(|(key, known)| match known {
            Known::Within(interval) if !counts(key) && written(&place_of(key)) => {
                Some((key, *interval))
            }
            _ => None,
        });
        let candidates: Vec<_> = candidates.collect();
        if candidates.is_empty() {
            return Vec::new();
        }
        let mut head = before.clone();
        self.head(&mut head);
        let writes = written_in(self.body, head);
        let hull = |(word, start): (&Key, Interval)| {
            let at = place_of(word);
            let mut all = start;
            for (place, parts) in writes.iter().filter(|(place, _)| overlap(place, &at)) {
                let inside = word.1.strip_prefix(&key(place)?.1[..])?;
                match parts.iter().find(|(at, _)| at == inside)? {
                    (_, Known::Within(interval)) => all = all.join(*interval),
                    (_, Known::Float(_)) => return None,
                }
            }
            Rule::Given.used();
            Some((word.clone(), Known::Within(all)))
        };
        candidates.into_iter().filter_map(hull).collect()
    }
}
