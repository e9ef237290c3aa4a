//! Conversions of numbers to bytes in a given order, independent of the machine.

use bessemer::prelude::*;

/// A packet's header: a sequence number and a value.
#[function]
pub fn head(sequence: u16, value: f32) -> [u8; 6] {
    let [s0, s1] = sequence.to_be_bytes();
    let [v0, v1, v2, v3] = value.to_le_bytes();
    [s0, s1, v0, v1, v2, v3]
}

/// The value in such a header.
#[function]
pub fn value(head: &[u8; 6]) -> f32 {
    f32::from_le_bytes([head[2], head[3], head[4], head[5]])
}
