//! `while` and `loop` declare how many passes they may take; one more is a fault.

use bessemer::prelude::*;

/// The greatest common divisor (Euclid): at most 24 divisions for 16 bits.
#[function]
pub fn common(a: u16, b: u16) -> u16 {
    let (mut a, mut b) = (a, b);
    #[bound(24)]
    while b != 0 {
        let rest = a % b;
        a = b;
        b = rest;
    }
    a
}
