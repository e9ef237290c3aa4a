//! A module of the author's that has the name of one of Rust's.
#![no_std]

use bessemer::prelude::*;

mod mem {
    /// Adds, which core's does not.
    pub fn swap(a: &mut u8, b: &mut u8) {
        *a += *b;
    }
}

/// Calls it.
#[function]
pub fn mixed(a: u8, b: u8) -> u8 {
    let (mut a, mut b) = (a, b);
    mem::swap(&mut a, &mut b);
    a
}
