//! `min`, `max` and `clamp` of what has an order and is no number: plain enums, tuples, arrays.

use bessemer::prelude::*;

/// How bad it is.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    #[default]
    Fine,
    Odd,
    Bad,
}

/// The worst so far, and the best since.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Watch {
    worst: Severity,
    best: Severity,
}

#[component]
impl Watch {
    /// Takes one in.
    #[entry]
    pub fn take(&mut self, now: Severity) -> Severity {
        self.worst = self.worst.max(now);
        let seen = &self.best;
        self.best = (*seen).min(now);
        self.worst
    }

    /// The nearest between the two; a fault if they are crossed.
    #[entry]
    pub fn limited(&mut self, now: Severity) -> Severity {
        now.clamp(self.best, self.worst)
    }
}

/// By the first, then by the second.
#[function]
pub fn first_of(one: (u8, i32), other: (u8, i32)) -> (u8, i32) {
    one.min(other)
}

/// The later date.
#[function]
pub fn later(one: &[u16; 3], other: [u16; 3]) -> [u16; 3] {
    (*one).max(other)
}

/// Floats are found behind references, as they have no `Ord`; integers are not.
#[function]
pub fn of_numbers(x: &i32, y: &f64) -> (i32, f64) {
    ((*x).max(3).clamp(-5, 7), y.min(2.0))
}
