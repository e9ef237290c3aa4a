//! `core::mem::swap` and `core::mem::replace` become assignments in the C.

use bessemer::prelude::*;
use core::mem;

/// Limits of a range.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    pub low: f64,
    pub high: f64,
}

/// Swaps the limits if they are in the wrong order.
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

/// Returns the content of a note and leaves it empty.
#[function]
pub fn noted(note: &mut Option<Limits>) -> Option<Limits> {
    core::mem::replace(note, None)
}

/// Replaces the oldest sample by a new one and returns it.
#[function]
pub fn oldest(ring: &mut [f32; 4], count: usize, sample: f32) -> f32 {
    mem::replace(&mut ring[count % 4], sample)
}
