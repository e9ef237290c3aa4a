#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Called from elsewhere.
#[function]
pub extern "C" fn called(x: f64) -> f64 {
    x
}

/// Without a guarantee.
#[function]
pub unsafe fn unchecked(x: f64) -> f64 {
    x
}

/// Never comes back.
#[function]
pub fn hang(x: f64) -> ! {
    loop {}
}

fn main() {}
