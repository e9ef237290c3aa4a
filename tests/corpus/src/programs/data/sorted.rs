//! Arrays, lists and slices are sorted by insertion, in the simulation as in the C: equal
//! elements keep their order. `total_cmp` orders floats, with NaN after all numbers.

use bessemer::prelude::*;

/// A change of outputs.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Switching {
    /// When, ticks.
    pub at: u16,
    /// Mask of outputs.
    pub outputs: u8,
}

/// The middle of nine.
#[function]
pub fn median(values: &[f64; 9]) -> f64 {
    let mut sorted = *values;
    sorted.sort_by(|a, b| a.total_cmp(b));
    sorted[4]
}

/// The middle of what there is.
#[function]
pub fn middle(values: &List<u16, 8>) -> Option<u16> {
    let mut sorted = *values;
    sorted.sort_unstable();
    sorted.get(sorted.len() / 2).copied()
}

/// Puts changes in the order of time.
#[function]
pub fn schedule(edges: &mut List<Switching, 5>) {
    edges.sort_by_key(|edge| edge.at);
}

/// Puts the latest first.
#[function]
pub fn latest_first(edges: &mut [Switching; 6]) {
    edges.sort_by(|one, other| other.at.cmp(&one.at));
}

/// Sorts all but the first, the greatest in front.
#[function]
pub fn downwards(values: &mut [f32; 5]) {
    values[1..].sort_unstable_by(|a, b| b.total_cmp(a));
}

/// The reading that is nearest to a guess.
#[function]
pub fn nearest(values: &[f64; 5], guess: f64) -> Option<f64> {
    values.iter().copied().min_by(|a, b| (a - guess).abs().total_cmp(&(b - guess).abs()))
}
