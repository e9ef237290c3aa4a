#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Perhaps with a field.
#[data]
pub struct Gains {
    /// Always.
    pub p: f64,
    /// Sometimes.
    #[cfg(debug_assertions)]
    pub i: f64,
}

/// Perhaps with a statement.
#[function]
pub fn respond(x: f64) -> f64 {
    #[allow(unused_mut)]
    let mut y = x;
    #[cfg(debug_assertions)]
    {
        y += 1.0;
    }
    #[inline]
    y
}

fn main() {}
