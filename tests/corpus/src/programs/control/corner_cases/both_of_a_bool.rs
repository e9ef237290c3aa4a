//! A `match` on a `bool` with an arm for both values, or for all that remain.

#![allow(missing_docs, clippy::match_single_binding)]

use bessemer::prelude::*;

#[function]
pub fn either(b: bool, n: &mut u32) -> u32 {
    match b {
        true | false => {
            *n = n.wrapping_mul(3).wrapping_add(1);
            *n
        }
    }
}

#[function]
pub fn asked(mut n: u32) -> u32 {
    match either(n > 7, &mut n) > 9 {
        false | true => n ^= 5,
    }
    n
}

#[function]
pub fn named(b: bool, n: u32) -> u32 {
    match b {
        true if n == 3 => 1,
        true | false if n > 100 => 2,
        false => n,
        true => n.wrapping_add(10),
    }
}
