//! A struct becomes a `typedef` with the same fields, in the same order, with the same comments.

use bessemer::prelude::*;

/// Reading of the altimeter.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// Height above ground, m.
    pub height: f64,
    /// Time since start, ms.
    pub time: u32,
    /// True if the echo was received.
    pub valid: bool,
}

/// The mean height of two readings if both are valid, m; otherwise the later one's.
#[function]
pub fn merged(one: &Reading, other: &Reading) -> f64 {
    if one.valid && other.valid {
        return (one.height + other.height) / 2.0;
    }
    if one.time > other.time { one.height } else { other.height }
}
