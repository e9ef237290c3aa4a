//! Tuples and arrays are ordered by the first parts that differ; plain enums that derive an order have `cmp`, too.

use bessemer::prelude::*;
use core::cmp::Ordering;

/// Urgency of a message.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Urgency {
    /// It may wait.
    #[default]
    Low,
    /// It is next.
    High,
    /// It is now.
    Alarm,
}

/// A message.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Message {
    pub urgency: Urgency,
    pub sequence: u16,
}

/// Returns true if a version of firmware is older.
#[function]
pub fn is_older(version: (u8, u8, u16), other: (u8, u8, u16)) -> bool {
    version < other
}

/// Order of two serial numbers.
#[function]
pub fn order(one: [u8; 3], other: [u8; 3]) -> Ordering {
    one.cmp(&other)
}

/// The most urgent first, and those that came first.
#[function]
pub fn queue(messages: &mut [Message; 4]) {
    messages.sort_by(|a, b| b.urgency.cmp(&a.urgency).then(a.sequence.cmp(&b.sequence)));
}

/// By number, then by urgency.
#[function]
pub fn archive(messages: &mut [Message; 4]) {
    messages.sort_by_key(|message| (message.sequence, message.urgency));
}

/// A point is before another from left to right, then upwards.
#[function]
pub fn before(one: (f64, f64), other: (f64, f64)) -> (bool, bool) {
    (one < other, one >= other)
}

/// A tuple that is matched by a name.
#[function]
pub fn matched(row: u8, column: u8) -> u16 {
    match (row, column) {
        (0, _) => 0,
        corner @ (1, 1) => u16::from(corner.0) + 100,
        place => u16::from(place.0) * 16 + u16::from(place.1),
    }
}
