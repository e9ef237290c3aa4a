//! Function summaries: intervals of the numbers in a function's result, for its callers.
//!
//! Meaning: in every execution of the function that returns without a fault, for any arguments, each listed number is
//! in its interval. So an index that one function computes needs no check where another uses it. Callees precede
//! their callers, so each summary is known at its calls.
//!
//! A function whose body does not run has no summary: an external function belongs to the firmware, and a kernel has
//! no IR body. Functions that `math.h` may replace return floats, which have no intervals.

use std::collections::BTreeMap;

use super::domain::Interval;
use super::known::{BROUGHT, Known, Parts};
use bessemer_ir::used::Rule;

/// Intervals of the numbers in a function's result, each with the fields that lead to it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Results(BTreeMap<Vec<u32>, Interval>);

impl Results {
    /// Returns the summary of a returned value. Normalised variants of an enum are local to the function: its caller
    /// reads the enum itself.
    pub(crate) fn of(parts: Parts) -> Results {
        let number = |(at, known): (Vec<u32>, Known)| match known {
            Known::Within(interval) if !at.contains(&BROUGHT) => Some((at, interval)),
            _ => None,
        };
        Results(parts.into_iter().filter_map(number).collect())
    }

    /// Returns the summary of both results, of which either may be returned.
    pub(crate) fn or(mut self, other: &Results) -> Results {
        self.0.retain(|at, interval| {
            let other = other.0.get(at).copied();
            other.inspect(|other| *interval = interval.join(*other)).is_some()
        });
        self
    }

    /// Returns the interval of the number at some fields.
    pub(super) fn at(&self, fields: &[u32]) -> Option<Interval> {
        self.0.get(fields).copied().inspect(|_| Rule::Returned.used())
    }

    /// Returns all intervals, as facts about a value.
    pub(super) fn all(&self) -> impl Iterator<Item = (&[u32], Known)> {
        let all = self.0.iter().inspect(|_| Rule::Returned.used());
        all.map(|(at, interval)| (at.as_slice(), Known::Within(*interval)))
    }
}
