//! `core::cmp::Reverse` reverses the order of its value: as a key, as a part of a key, and as a value.

use core::cmp::{Ordering, Reverse};

use bessemer::prelude::*;

/// A task, and how urgent it is.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Job {
    /// The greatest is first.
    pub urgency: u8,
    /// When it is due, ms.
    pub due: i16,
    /// Serial number.
    pub number: u8,
}

/// The most urgent first; of those the one that is due.
#[function]
pub fn planned(jobs: &mut [Job; 5]) {
    jobs.sort_by_key(|job| (Reverse(job.urgency), job.due));
}

/// The other way round, but for what is due.
#[function]
pub fn put_off(jobs: &mut [Job; 5]) {
    jobs.sort_by_key(|job| core::cmp::Reverse((Reverse(job.urgency), job.due)));
}

/// The least urgent, the first of them, and the last of the most urgent.
#[function]
pub fn ends(jobs: &[Job; 5]) -> (Option<Job>, Option<Job>) {
    let least = jobs.iter().copied().min_by_key(|job| (job.urgency, Reverse(job.due)));
    (least, jobs.iter().copied().min_by_key(|job| Reverse(job.urgency)))
}

/// Order of two numbers by each comparison.
#[function]
pub fn compared(a: i16, b: i16) -> (bool, bool, bool, bool, bool, Ordering) {
    let (one, other) = (Reverse(a), Reverse(b));
    (one < other, one <= other, one > other, one >= other, one == other, one.cmp(&other))
}

/// A NaN is before, behind and at no number, whichever way.
#[function]
pub fn of_floats(a: f64, b: f64) -> (bool, bool, bool, Option<Ordering>) {
    let (one, other) = (Reverse(a), Reverse(b));
    (one < other, one >= other, one != other, one.partial_cmp(&other))
}

/// The least as the greatest of what is turned round.
#[function]
pub fn least(values: &[u8; 4], floor: u8) -> Option<u8> {
    let Reverse(least) = values.iter().copied().map(Reverse).max()?;
    Some(Reverse(least).min(Reverse(floor)).0)
}

/// Held, given and lent.
#[function]
pub fn first(
    held: core::cmp::Reverse<[u8; 2]>,
    lent: &core::cmp::Reverse<[u8; 2]>,
) -> core::cmp::Reverse<[u8; 2]> {
    if held < *lent { held } else { *lent }
}
