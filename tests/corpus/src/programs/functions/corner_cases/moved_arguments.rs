//! `move` closures as arguments, whose variables change later or in the closure.

use bessemer::prelude::*;

#[function]
fn twice(mut f: impl FnMut() -> u32) -> u32 {
    let first = f();
    first.wrapping_mul(31) ^ f()
}

#[function]
fn changed(x: &mut u32) -> u32 {
    *x ^= 9;
    *x
}

#[function]
pub fn in_chains(a: [u32; 4], b: u32) -> u32 {
    let mut n = b;
    let sum = a.iter().fold(1_u32, move |sum, x| {
        n = n.wrapping_add(*x);
        sum.wrapping_mul(3) ^ n
    });
    sum ^ n
}

#[function]
pub fn before_a_change(a: [u32; 4], b: u32) -> u32 {
    let mut n = b;
    let it = a.iter().map(move |x| *x ^ n);
    n = n.wrapping_mul(3);
    it.fold(n, |sum, x| sum.wrapping_mul(31).wrapping_add(x))
}

#[function]
pub fn of_a_function(a: u32) -> u32 {
    let mut n = a;
    let one = twice(move || {
        n = n.wrapping_add(2);
        n
    });
    let other = twice(move || {
        n ^= one;
        n
    });
    one ^ other.wrapping_mul(3) ^ n
}

#[function]
pub fn two_copies(a: [u32; 4], b: u32) -> u32 {
    let mut n = b;
    let pairs = a.iter().map(move |x| {
        n ^= *x;
        n
    });
    let sum = pairs.zip(a.iter().map(move |x| {
        n = n.wrapping_add(*x);
        n
    }));
    sum.fold(n, |sum, (x, y)| sum.wrapping_mul(31) ^ x.wrapping_mul(5).wrapping_add(y))
}

#[function]
pub fn anew_in_closures(a: [[u32; 3]; 2], b: u32) -> u32 {
    let mut n = b;
    let each = |row: &[u32; 3]| {
        row.iter().fold(0_u32, move |sum, x| {
            n = n.wrapping_add(*x);
            sum.wrapping_mul(31) ^ n
        })
    };
    let first = a.iter().fold(0_u32, |sum, row| sum.wrapping_mul(3).wrapping_add(each(row)));
    n ^= 1;
    first ^ n
}

#[function]
pub fn in_heads(a: [u32; 4], b: u32) -> u32 {
    let mut n = b % 16;
    let mut sum = 0_u32;
    if a.iter().any(move |x| *x % 16 > n) {
        n += 1;
    }
    for x in a.iter().map(move |x| *x ^ n) {
        n = n.wrapping_add(x);
        sum = sum.wrapping_mul(31) ^ x;
    }
    match a.iter().position(move |x| *x == n) {
        Some(at) => n ^= at as u32,
        None => n = n.wrapping_add(7),
    }
    sum ^ n
}

#[function]
pub fn beside_reads(a: [u32; 4], b: u32) -> u32 {
    let mut n = b;
    let sum = n ^ a.iter().filter(move |x| **x > n).count() as u32 ^ n;
    let last = changed(&mut n);
    sum ^ last ^ n
}

#[function]
pub fn optional(a: u32, b: u32) -> u32 {
    let mut n = b;
    let one = a.checked_sub(5).map(move |x| {
        n = n.wrapping_add(1);
        x ^ n
    });
    n ^= 6;
    let other = one.map_or(n, move |x| x.wrapping_add(n));
    n = n.wrapping_mul(3);
    other ^ n
}
