//! `while let` declares its bound, as `while` does.

use bessemer::prelude::*;

/// The number divided by two, if it is even.
#[function]
pub fn halved(n: u32) -> Option<u32> {
    if n % 2 == 0 && n > 0 { Some(n / 2) } else { None }
}

/// The odd part of a number.
#[function]
pub fn odd_part(n: u32) -> u32 {
    let mut odd = n;
    #[bound(32)]
    while let Some(half) = halved(odd) {
        odd = half;
    }
    odd
}
