//! `core::mem::swap` and `core::mem::replace` are assignments in the C.

use bessemer::prelude::*;
use core::mem;

/// Limits of a range.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    pub low: f64,
    pub high: f64,
}

/// Puts the limits in their order.
#[function]
pub fn put_in_order(limits: &mut Limits) {
    if limits.low > limits.high {
        core::mem::swap(&mut limits.low, &mut limits.high);
    }
}

/// Exchanges two buffers.
#[function]
pub fn flip(front: &mut [u8; 6], back: &mut [u8; 6]) {
    mem::swap(front, back);
}

/// Change of a signal since the last call.
#[function]
pub fn moved(last: &mut f64, now: f64) -> f64 {
    now - core::mem::replace(last, now)
}

/// Takes what was noted, and notes nothing.
#[function]
pub fn noted(note: &mut Option<Limits>) -> Option<Limits> {
    core::mem::replace(note, None)
}

/// Puts a sample where the oldest one stands, and gives that.
#[function]
pub fn oldest(ring: &mut [f32; 4], count: usize, sample: f32) -> f32 {
    mem::replace(&mut ring[count % 4], sample)
}
