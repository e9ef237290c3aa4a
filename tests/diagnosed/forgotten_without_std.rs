//! Functions and methods without attribute, where there is no `std` that has their methods of floats.
#![no_std]
use bessemer::prelude::*;

fn cell(x: f64) -> f64 {
    x.floor()
}

fn decayed(x: f32) -> f32 {
    (-x).exp()
}

/// A filter of which the block is not marked.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Filter {
    /// The level.
    pub level: f64,
}

impl Filter {
    fn angle(&self) -> f64 {
        self.level.atan2(2.0)
    }
}

/// Calls them.
#[function]
pub fn caller(x: f64, y: f32, filter: &Filter) -> f64 {
    cell(x) + f64::from(decayed(y)) + filter.angle()
}
