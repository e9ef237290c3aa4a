//! `insert`, `remove`, `swap_remove` and `retain` of lists.

use bessemer::prelude::*;

/// Inserts a job by its cost, the cheapest first.
#[function]
pub fn queued(jobs: &mut List<u8, 6>, cost: u8) -> usize {
    let at = jobs.iter().position(|job| *job > cost).unwrap_or(jobs.len());
    jobs.insert(at, cost);
    at
}

/// Removes the first job, and all that cost more than a limit.
#[function]
pub fn served(jobs: &mut List<u8, 6>, limit: u8) -> u8 {
    let first = jobs.remove(0);
    jobs.retain(|job| *job <= limit);
    first
}

/// The bytes of two numbers.
#[function]
pub fn message(sequence: u16, value: u32) -> List<u8, 6> {
    let mut bytes = List::new();
    bytes.extend(sequence.to_be_bytes());
    bytes.extend(value.to_be_bytes().iter().rev());
    bytes
}

/// Removes an element; the last one takes its place.
#[function]
pub fn without(list: &List<u8, 6>, at: usize) -> List<u8, 6> {
    let mut left = *list;
    left.swap_remove(at);
    left.extend_from_slice(&list[at..]);
    left
}
