#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Calls core and std.
#[function]
pub fn standard_library(a: f64, cells: &mut [u8; 4], mut i: usize) -> f64 {
    core::hint::black_box(a);
    // Which cell is written would change on the way.
    core::mem::replace(&mut cells[i], { i += 1; 3 });
    let low = core::hint::black_box(1);
    a + std::time::Duration::ZERO.as_secs_f64() + low as f64 + Vector2::default().x
}

fn main() {}
