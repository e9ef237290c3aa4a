#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Calls core and std.
#[function]
pub fn standard_library(a: f64) -> f64 {
    core::hint::black_box(a);
    let low = core::hint::black_box(1);
    a + std::time::Duration::ZERO.as_secs_f64() + low as f64 + Vector2::default().x
}

fn main() {}
