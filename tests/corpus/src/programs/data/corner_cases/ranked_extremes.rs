//! `min`, `max` and `clamp` of ordered types that are not numbers: plain enums, tuples, arrays.

use bessemer::prelude::*;

/// Severity of a fault.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    #[default]
    Fine,
    Odd,
    Bad,
}

/// The worst severity so far, and the best since.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Watch {
    worst: Severity,
    best: Severity,
}

#[component]
impl Watch {
    /// Takes a severity; returns the worst so far.
    #[entry]
    pub fn take(&mut self, now: Severity) -> Severity {
        self.worst = self.worst.max(now);
        let seen = &self.best;
        self.best = (*seen).min(now);
        self.worst
    }

    /// Limits a severity to the range between the two; a fault if they are in the wrong order.
    #[entry]
    pub fn limited(&mut self, now: Severity) -> Severity {
        now.clamp(self.best, self.worst)
    }
}

/// The lesser pair: by the first part, then by the second.
#[function]
pub fn first_of(one: (u8, i32), other: (u8, i32)) -> (u8, i32) {
    one.min(other)
}

/// The later date.
#[function]
pub fn later(one: &[u16; 3], other: [u16; 3]) -> [u16; 3] {
    (*one).max(other)
}

/// `min` of references: for floats it is a method of the number, for integers of `Ord`.
#[function]
pub fn of_numbers(x: &i32, y: &f64) -> (i32, f64) {
    ((*x).max(3).clamp(-5, 7), y.min(2.0))
}

/// Minimum, maximum and clamp of references, as `Ord` is implemented for them, and the sum.
#[function]
pub fn of_references(levels: &[i32; 5], low: i32, high: i32) -> (i32, i32, i32, i64) {
    let most = *levels.iter().fold(&levels[0], |most, level| most.max(level));
    let least = levels.iter().fold(&levels[0], |least, level| if level < least { level } else { least.min(level) });
    let mut sum = 0_i64;
    for level in levels {
        sum += i64::from(*level.max(&3).min(&high));
    }
    (*least, most, levels[2].clamp(low, high).max(low).min(levels[4]), sum)
}

/// Minimum, maximum and clamp of references to types that are not numbers.
#[function]
pub fn worse(seen: &Severity, others: &[Severity; 3], pair: &(u8, i32)) -> (Severity, (u8, i32), Severity) {
    let worst = *others.iter().fold(seen, |worst, other| worst.max(other));
    let first = others.first().map(|first| *first.min(seen)).unwrap_or(Severity::Bad);
    (worst, *pair.clamp(&(1, -3), &(200, 4)), first)
}

/// A copied maximum does not change with later writes.
#[function]
pub fn kept(values: &mut [u16; 3]) -> u16 {
    let most = values[0].max(values[1]).max(values[2]);
    values[0] = most / 2;
    let two = values[1];
    let lesser = (&two).min(&most);
    values[1] = 7;
    *lesser + values[1]
}
