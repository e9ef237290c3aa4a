//! `core::cmp::Reverse` reverses the order of its value: as a key, as a part of a key, and as a value.

use core::cmp::{Ordering, Reverse};

use bessemer::prelude::*;

/// A job with its urgency and due time.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Job {
    /// Urgency; the greatest is the most urgent.
    pub urgency: u8,
    /// Due time, ms.
    pub due: i16,
    /// Serial number.
    pub number: u8,
}

/// Sorts by urgency, the most urgent first, and then by due time.
#[function]
pub fn planned(jobs: &mut [Job; 5]) {
    jobs.sort_by_key(|job| (Reverse(job.urgency), job.due));
}

/// Sorts the least urgent first, and then by due time.
#[function]
pub fn put_off(jobs: &mut [Job; 5]) {
    jobs.sort_by_key(|job| core::cmp::Reverse((Reverse(job.urgency), job.due)));
}

/// The first of the least urgent jobs, and the last of the most urgent.
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

/// Comparisons with a NaN are false, in either order.
#[function]
pub fn of_floats(a: f64, b: f64) -> (bool, bool, bool, Option<Ordering>) {
    let (one, other) = (Reverse(a), Reverse(b));
    (one < other, one >= other, one != other, one.partial_cmp(&other))
}

/// The minimum, as the maximum of reversed values.
#[function]
pub fn least(values: &[u8; 4], floor: u8) -> Option<u8> {
    let Reverse(least) = values.iter().copied().map(Reverse).max()?;
    Some(Reverse(least).min(Reverse(floor)).0)
}

/// Reversed values in a field, as an argument, and by reference.
#[function]
pub fn first(
    held: core::cmp::Reverse<[u8; 2]>,
    lent: &core::cmp::Reverse<[u8; 2]>,
) -> core::cmp::Reverse<[u8; 2]> {
    if held < *lent { held } else { *lent }
}
