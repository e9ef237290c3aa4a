//! Enumerated items of chains.

use bessemer::prelude::*;

/// A filter whose power can be taken once.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bin {
    /// The two parts of its state.
    pub parts: [f32; 2],
}

#[data]
impl Bin {
    /// Returns the power and resets the filter.
    pub fn take(&mut self) -> f32 {
        let [a, b] = self.parts;
        self.parts = [0.0; 2];
        a * a + b * b
    }
}

/// The strongest bin and its index.
#[function]
pub fn strongest(bins: &mut [Bin; 4]) -> Option<(usize, f32)> {
    bins.iter_mut().map(Bin::take).enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b))
}

/// Sum of the items that pass a filter, weighted by their number among them.
#[function]
pub fn weighted(values: &[i16; 6], least: i16) -> i64 {
    let mut sum = 0;
    for (rank, value) in values.iter().filter(|value| **value > least).enumerate() {
        sum += (rank as i64 + 1) * i64::from(*value);
    }
    sum
}

/// The sum of every second square.
#[function]
pub fn every_second(count: u8) -> u32 {
    let squares = (0..u32::from(count)).map(|x| x * x);
    squares.enumerate().filter(|(at, _)| at % 2 == 1).map(|(_, square)| square).fold(0, |a, b| a ^ b)
}

/// Contents of two chained groups.
#[function]
pub fn gathered(first: &mut [Bin; 2], second: &mut [Bin; 3], x: f32) -> f32 {
    let mut sum = 0.0;
    for bin in first.iter_mut().chain(second.iter_mut()) {
        if bin.parts[0] < 0.0 {
            continue;
        }
        bin.parts[1] += x;
        sum += bin.take();
    }
    sum
}
