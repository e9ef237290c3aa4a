#![no_std]
extern crate std;

use std::boxed::Box;
use std::vec;
use std::vec::Vec;

use bessemer::prelude::*;

/// Collects on the heap.
#[function]
pub fn heap(x: f64) -> f64 {
    let mut seen: Vec<f64> = Vec::new();
    seen.push(x);
    let boxed = Box::new(x);
    let all = vec![x, *boxed];
    seen[0] + all[0]
}

fn main() {}
