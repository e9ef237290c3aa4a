#![no_std]
extern crate std;

use bessemer::prelude::*;

use std::boxed::Box;
use std::vec::Vec;

/// Fields on the heap, and of no size.
#[data]
pub struct Log {
    /// Samples.
    pub samples: Vec<f64>,
    /// A law.
    pub law: Box<dyn Fn(f64) -> f64>,
    /// Perhaps a value.
    pub last: Option<f64>,
}

fn main() {}
