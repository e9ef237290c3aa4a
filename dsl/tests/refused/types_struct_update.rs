#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Two gains.
#[data]
#[derive(Clone, Copy)]
pub struct Gains {
    /// Proportional.
    pub p: f64,
    /// Integral.
    pub i: f64,
}

/// Copies the rest.
#[function]
pub fn struct_update(gains: Gains) -> Gains {
    Gains { p: 2.0 * gains.p, ..gains }
}

fn main() {}
