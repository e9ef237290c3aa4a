//! Sizes that are assigned repeatedly: some always fit into 32 bits, others do not, and results of two that fit may
//! not fit either.

use bessemer::prelude::*;

/// Number of increasing neighbours: the counter is below 8.
#[function]
pub fn rises(values: &[u8; 8]) -> usize {
    let (mut k, mut count) = (0, 0);
    while k + 1 < 8 {
        if values[k] < values[k + 1] {
            count += 1;
        }
        k += 1;
    }
    count
}

/// Number of halvings of a size until it is 0.
#[function]
pub fn halved(n: usize) -> (usize, u32) {
    let (mut rest, mut last, mut count) = (n, 0, 0);
    while rest > 0 {
        last = rest;
        rest /= 2;
        count += 1;
    }
    (last + n % 2, count)
}

/// Two sizes that fit, and results that need all 64 bits.
#[function]
pub fn computed(a: u16, b: u16) -> [usize; 5] {
    let (mut x, mut y) = (usize::from(a), 3);
    if a > 9 {
        x += 60_000;
    }
    if b > a {
        y = usize::from(b) + 70_000;
    }
    [x * y, x.wrapping_sub(y), !x, x << 30, x.saturating_sub(y) + (x as i32 as usize)]
}

/// A size that fits after each branch but the last.
#[function]
pub fn chosen(n: usize, kind: u8) -> usize {
    let mut at = 0;
    if kind > 3 {
        at = n % 8;
    } else if kind > 1 {
        at = n.min(1_000);
    } else if kind == 1 {
        at = n;
    }
    at ^ usize::from(kind)
}
