//! A copy before an assignment that determines its array is of that array only.
#![no_std]
use bessemer::prelude::*;

/// Mixes both arrays.
#[function]
pub fn mixed(a: &mut [i16; 5], b: &mut [i16; 5], n: usize) -> i16 {
    let mut best: Option<&mut i16> = None;
    let mut second: Option<&mut i16> = None;
    for (x, y) in a.iter_mut().zip(b.iter_mut()) {
        second = best;
        best = Some(x);
        if n == 3 {
            second = Some(y);
        }
    }
    if let Some(s) = second {
        *s = 3;
    }
    a[0]
}

/// Mixes slices of both.
#[function]
pub fn kept(a: &[i16; 5], b: &[i16; 5], n: usize) -> i16 {
    let mut last: Option<&[i16]> = None;
    let mut kept: Option<&[i16]> = None;
    for i in 0..3 {
        kept = last;
        last = Some(&a[i..]);
        if n == 9 {
            kept = Some(&b[1..]);
        }
    }
    kept.map_or(0, |k| k[0])
}

/// Never shown.
#[function]
pub fn never(n: usize) -> f64 {
    let o: Option<&mut f64> = None;
    if n == 3 {
        if let Some(x) = o {
            *x = 1.0;
        }
    }
    0.0
}
