//! `chain` joins arrays, `step_by` takes every n-th element, and ranges have a step and a run-time end.

use bessemer::prelude::*;

/// A reading of a cell.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    pub voltage: f32,
    pub valid: bool,
}

/// Number of low cells in a battery with additional cells.
#[function]
pub fn low(own: &[Cell; 4], added: &[Cell; 3], limit: f32) -> usize {
    own.iter().chain(added.iter()).filter(|cell| cell.valid && cell.voltage < limit).count()
}

/// A checksum over header and payload.
#[function]
pub fn checksum(header: &[u8; 3], payload: &List<u8, 6>) -> u8 {
    let mut sum = 0xFF_u8;
    for byte in header.iter().chain(payload) {
        sum = sum.rotate_left(1) ^ byte;
    }
    sum
}

/// The index of the first zero in two chained arrays.
#[function]
pub fn first_zero(before: &[i16; 3], now: &[i16; 2]) -> Option<usize> {
    before.iter().chain(now).position(|x| *x == 0)
}

/// The sum of the left channel; the samples of the channels alternate.
#[function]
pub fn left(samples: &[i16; 7]) -> i32 {
    samples.iter().step_by(2).map(|x| i32::from(*x)).sum()
}

/// Sum of the samples of the right channel, weighted by their number.
#[function]
pub fn right(samples: &[i16; 7]) -> i32 {
    let mut sum = 0;
    for (i, sample) in samples.iter().skip(1).step_by(2).enumerate() {
        sum += i32::from(*sample) * (i as i32 + 1);
    }
    sum
}

/// Number of marks on a scale, and the sum of their positions.
#[function]
pub fn marks(length: u8) -> (u8, u32) {
    let mut count = 0;
    let mut sum = 0;
    for place in (0..=length).step_by(5) {
        count += 1;
        sum += u32::from(place);
    }
    (count, sum)
}
