//! Tuples and arrays are ordered by their first differing elements; plain enums that derive an order have `cmp`, too.

use bessemer::prelude::*;
use core::cmp::Ordering;

/// Urgency of a message.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Urgency {
    /// Can wait.
    #[default]
    Low,
    /// Is sent next.
    High,
    /// Is sent immediately.
    Alarm,
}

/// A message.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Message {
    pub urgency: Urgency,
    pub sequence: u16,
}

/// Returns true if a version is older than another.
#[function]
pub fn is_older(version: (u8, u8, u16), other: (u8, u8, u16)) -> bool {
    version < other
}

/// Order of two serial numbers.
#[function]
pub fn order(one: [u8; 3], other: [u8; 3]) -> Ordering {
    one.cmp(&other)
}

/// Sorts by urgency, the most urgent first, and then by number.
#[function]
pub fn queue(messages: &mut [Message; 4]) {
    messages.sort_by(|a, b| b.urgency.cmp(&a.urgency).then(a.sequence.cmp(&b.sequence)));
}

/// Sorts by number and then by urgency.
#[function]
pub fn archive(messages: &mut [Message; 4]) {
    messages.sort_by_key(|message| (message.sequence, message.urgency));
}

/// Compares points: from left to right, and then upwards.
#[function]
pub fn before(one: (f64, f64), other: (f64, f64)) -> (bool, bool) {
    (one < other, one >= other)
}

/// A named value of a matched tuple.
#[function]
pub fn matched(row: u8, column: u8) -> u16 {
    match (row, column) {
        (0, _) => 0,
        corner @ (1, 1) => u16::from(corner.0) + 100,
        place => u16::from(place.0) * 16 + u16::from(place.1),
    }
}
