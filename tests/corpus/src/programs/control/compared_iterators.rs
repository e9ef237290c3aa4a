//! Iterators compared as sequences, and the minimum of a named iterator.

use core::cmp::Ordering;

use bessemer::prelude::*;

/// Compares by the first items that differ; if there are none, the shorter sequence is less.
#[function]
pub fn compared(a: &[i16; 5], b: &[i16; 4]) -> (Ordering, bool, bool) {
    (a.iter().cmp(b.iter()), a.iter().ge(b.iter()), a.iter().skip(1).eq(b))
}

/// Comparisons of sequences of floats, some of which are unordered.
#[function]
pub fn floats(x: &[f64; 3], y: &[f64; 3], n: usize) -> [bool; 4] {
    let x = x.iter().take(n % 4);
    [x.clone().lt(y), x.clone().le(y), x.clone().gt(y.iter()), x.ge(y.iter())]
}

/// The minimum and maximum of named iterators.
#[function]
pub fn best(a: &[i16; 5], x: &[f64; 4]) -> (Option<i16>, Option<f64>, Option<i16>, Option<usize>) {
    let odd = a.iter().copied().filter(|x| x % 2 == 1);
    let half = x.iter().map(|x| 0.5 * x);
    let low = a.iter().copied().skip(1);
    let numbered = a.iter().enumerate();
    (
        odd.min_by(|a, b| b.cmp(a)),
        half.max_by(|a, b| a.total_cmp(b)),
        low.max_by_key(|x| x.wrapping_mul(3)),
        numbered.min_by_key(|(_, x)| **x).map(|(i, _)| i),
    )
}

/// A loop over two chained arrays that ends within the first or the second.
#[function]
pub fn raised(a: &mut [i16; 3], b: &mut [i16; 3], limit: i16) -> bool {
    for x in a.iter_mut().chain(b.iter_mut()) {
        if *x > limit {
            break;
        }
        if *x == limit {
            return true;
        }
        *x = x.wrapping_add(1);
    }
    false
}
