//! Selects the best of several items: `min_by_key` returns the first minimum, `max_by_key` the last maximum.

use core::cmp::Ordering;

use bessemer::prelude::*;

/// A route and its cost.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Way {
    pub to: u8,
    pub cost: u16,
}

/// The route with the least cost.
#[function]
pub fn cheapest(ways: &[Way; 4]) -> Way {
    ways.iter().min_by_key(|way| way.cost).copied().unwrap_or(ways[0])
}

/// Index of the element nearest to `to`.
#[function]
pub fn nearest(values: &[f32; 5], to: f32) -> Option<usize> {
    let best = values.iter().enumerate().min_by(|a, b| {
        (a.1 - to).abs().partial_cmp(&(b.1 - to).abs()).unwrap_or(Ordering::Equal)
    })?;
    Some(best.0)
}

/// Index of the largest element.
#[function]
pub fn peak(values: &[u8; 5]) -> Option<usize> {
    values.iter().enumerate().max_by_key(|(_, value)| **value).map(|(index, _)| index)
}
