//! Numbers for what comes out of a chain.

use bessemer::prelude::*;

/// A filter that gives its power once.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bin {
    /// Its two parts.
    pub parts: [f32; 2],
}

#[data]
impl Bin {
    /// The power; the filter starts anew.
    pub fn take(&mut self) -> f32 {
        let [a, b] = self.parts;
        self.parts = [0.0; 2];
        a * a + b * b
    }
}

/// The strongest, and where it stands.
#[function]
pub fn strongest(bins: &mut [Bin; 4]) -> Option<(usize, f32)> {
    bins.iter_mut().map(Bin::take).enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b))
}

/// Numbers of those that are left over alone.
#[function]
pub fn weighted(values: &[i16; 6], least: i16) -> i64 {
    let mut sum = 0;
    for (rank, value) in values.iter().filter(|value| **value > least).enumerate() {
        sum += (rank as i64 + 1) * i64::from(*value);
    }
    sum
}

/// Every second of the squares.
#[function]
pub fn every_second(count: u8) -> u32 {
    let squares = (0..u32::from(count)).map(|x| x * x);
    squares.enumerate().filter(|(at, _)| at % 2 == 1).map(|(_, square)| square).fold(0, |a, b| a ^ b)
}

/// Contents of two groups, one after the other.
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
