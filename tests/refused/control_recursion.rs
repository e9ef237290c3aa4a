#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Calls itself.
#[function]
pub fn recursion(n: u32) -> u32 {
    if n == 0 { 1 } else { n * recursion(n - 1) }
}

fn main() {}
