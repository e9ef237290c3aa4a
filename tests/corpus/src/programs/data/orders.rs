//! An `Ordering` is a value: it is matched, stored, reversed and returned.

use core::cmp::Ordering;

use bessemer::prelude::*;

/// A task with its urgency and deadline.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Task {
    /// Priority; the lowest number is the most urgent.
    pub priority: u8,
    /// Deadline, ms.
    pub deadline: u32,
    /// Duration, s.
    pub effort: f32,
}

/// Moves one step towards a target.
#[function]
pub fn towards(position: i16, target: i16) -> i16 {
    match position.cmp(&target) {
        Ordering::Less => position + 1,
        Ordering::Equal => position,
        Ordering::Greater => position - 1,
    }
}

/// Order of two tasks: by priority, then by deadline, then by duration.
#[function]
pub fn first(one: &Task, other: &Task) -> Ordering {
    one.priority
        .cmp(&other.priority)
        .then(one.deadline.cmp(&other.deadline))
        .then_with(|| one.effort.total_cmp(&other.effort))
}

/// The tasks in order.
#[function]
pub fn scheduled(tasks: &[Task; 4]) -> [Task; 4] {
    let mut sorted = *tasks;
    sorted.sort_by(|one, other| first(one, other));
    sorted
}

/// Returns true if a reading exceeds a limit; false for a NaN.
#[function]
pub fn is_beyond(reading: f64, limit: f64) -> bool {
    reading.partial_cmp(&limit).is_some_and(|order| order.is_gt())
}

/// The last of the longest tasks.
#[function]
pub fn longest(tasks: &[Task; 4]) -> Option<Task> {
    tasks.iter().copied().max_by(|a, b| a.effort.total_cmp(&b.effort).then(a.deadline.cmp(&b.deadline)))
}
