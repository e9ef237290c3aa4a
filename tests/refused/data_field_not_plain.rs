#![no_std]
extern crate std;

use bessemer::prelude::*;

use core::time::Duration;

/// A type of the author's, without its attribute.
#[derive(Clone, Copy)]
pub struct Limits {
    /// The lower.
    pub low: f64,
}

/// Holds what is not plain.
#[data]
pub struct Axis {
    /// Not marked.
    pub limits: Limits,
    /// Type of the standard library.
    pub period: Duration,
}

fn main() {}
