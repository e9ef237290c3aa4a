//! Loops of which nothing shows that they end.
use bessemer::prelude::*;

/// Down to one.
#[function]
pub fn halved(x: f64) -> f64 {
    let mut rest = x;
    while rest > 1.0 {
        rest /= 2.0;
    }
    rest
}

/// Not in every pass.
#[function]
pub fn skipped(n: u8) -> u8 {
    let mut i = 0;
    while i < n {
        if i == 7 {
            continue;
        }
        i += 1;
    }
    i
}

/// The limit runs away.
#[function]
pub fn chased(n: u8) -> u8 {
    let (mut i, mut end) = (0, n);
    while i < end {
        i += 1;
        end += 1;
    }
    i
}

/// It breaks at its end.
#[function]
pub fn late(x: f64) -> f64 {
    let mut rest = x;
    loop {
        rest /= 2.0;
        if rest < 1.0 {
            return rest;
        }
    }
}

/// By way of a function.
#[function]
pub fn lent(n: u8) -> u8 {
    let mut i = 0;
    while i < n {
        further(&mut i);
    }
    i
}

#[function]
fn further(i: &mut u8) {
    *i ^= 1;
}

/// The wrong way.
#[function]
pub fn away(n: u8) -> u8 {
    let mut i = n;
    while i < 100 {
        i -= 1;
    }
    i
}
