//! Function summaries: intervals of the numbers in a function's result, which its callers use.
//!
//! The meaning: in every execution of the function that returns without a fault, whatever its arguments, each number that is
//! listed lies in its interval. So an index that one function chooses needs no check where another one uses it. Callees stand
//! before their callers, so that each is known where it is called.
//!
//! Of a body that is not the one that runs nothing is listed: what an external function returns is the firmware's, and a
//! kernel's body is none. What `math.h` may represent gives floats, of which no interval is kept.

use std::collections::BTreeMap;

use super::domain::Interval;
use super::known::{BROUGHT, Known, Parts};
use bessemer_ir::used::Rule;

/// Numbers in the result of a function, each with the fields that lead to it.
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

    /// With another value that may be returned instead.
    pub(crate) fn or(mut self, other: &Results) -> Results {
        self.0.retain(|at, interval| {
            let other = other.0.get(at).copied();
            other.inspect(|other| *interval = interval.join(*other)).is_some()
        });
        self
    }

    /// The number at some fields.
    pub(super) fn at(&self, fields: &[u32]) -> Option<Interval> {
        self.0.get(fields).copied().inspect(|_| Rule::Returned.used())
    }

    /// All of them, as what is known of a value.
    pub(super) fn all(&self) -> impl Iterator<Item = (&[u32], Known)> {
        let all = self.0.iter().inspect(|_| Rule::Returned.used());
        all.map(|(at, interval)| (at.as_slice(), Known::Within(*interval)))
    }
}
