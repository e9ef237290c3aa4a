//! A case.
#![no_std]
use bessemer::prelude::*;

/// Gains.
#[data]
#[derive(Clone, Copy, Default)]
pub struct Gains {
    /// Proportional.
    pub p: f64,
}

impl Gains {
    /// Not part of the DSL.
    pub fn twice(&self) -> f64 {
        2.0 * self.p
    }
}

/// Calls it.
#[function]
pub fn caller(gains: &Gains) -> f64 {
    gains.twice()
}
