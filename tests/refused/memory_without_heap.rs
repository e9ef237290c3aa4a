#![no_std]
extern crate std;

use bessemer::prelude::*;

/// `Vec` without an import, as a model would write it.
#[function]
pub fn without_heap(x: f64, samples: &Vec<f64>) -> f64 {
    x + samples.len() as f64
}

fn main() {}
