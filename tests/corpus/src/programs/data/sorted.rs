//! Arrays, lists and slices are sorted by insertion, in the simulation as in the C: equal elements keep their order.
//! `total_cmp` orders floats, with NaN last.

use bessemer::prelude::*;

/// A change of the outputs at a time.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Switching {
    /// Time, ticks.
    pub at: u16,
    /// Mask of the outputs that change.
    pub outputs: u8,
}

/// The median of nine values.
#[function]
pub fn median(values: &[f64; 9]) -> f64 {
    let mut sorted = *values;
    sorted.sort_by(|a, b| a.total_cmp(b));
    sorted[4]
}

/// The median of a list; `None` if it is empty.
#[function]
pub fn middle(values: &List<u16, 8>) -> Option<u16> {
    let mut sorted = *values;
    sorted.sort_unstable();
    sorted.get(sorted.len() / 2).copied()
}

/// Sorts changes by time.
#[function]
pub fn schedule(edges: &mut List<Switching, 5>) {
    edges.sort_by_key(|edge| edge.at);
}

/// Sorts changes by time, the latest first.
#[function]
pub fn latest_first(edges: &mut [Switching; 6]) {
    edges.sort_by(|one, other| other.at.cmp(&one.at));
}

/// Sorts all values but the first in descending order.
#[function]
pub fn downwards(values: &mut [f32; 5]) {
    values[1..].sort_unstable_by(|a, b| b.total_cmp(a));
}

/// The reading that is nearest to a guess.
#[function]
pub fn nearest(values: &[f64; 5], guess: f64) -> Option<f64> {
    values.iter().copied().min_by(|a, b| (a - guess).abs().total_cmp(&(b - guess).abs()))
}
