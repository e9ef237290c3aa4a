//! `take` after an adapter, zips, and equality of sequences.

use bessemer::prelude::*;

/// The sum of the first `most` items that are not negative.
#[function]
pub fn first_of(values: &[i32; 6], most: u8) -> i32 {
    let good = values.iter().filter(|value| **value >= 0);
    good.take(usize::from(most)).fold(1, |joined: i32, value| joined.wrapping_mul(3) ^ value)
}

/// Skipped items and an early end; no more items are computed than taken.
#[function]
pub fn looked_at(values: &[u8; 6], most: u8, seen: &mut u32) -> u32 {
    let mut joined = 0_u32;
    for (i, value) in values
        .iter()
        .inspect(|x| *seen = seen.wrapping_mul(3) ^ u32::from(**x))
        .take(most as usize)
        .enumerate()
    {
        if *value > 200 {
            continue;
        }
        if *value == 3 {
            break;
        }
        joined = joined.wrapping_mul(5) ^ u32::from(*value) ^ i as u32;
    }
    joined
}

/// Pairs from two arrays, as far as the shorter one goes.
#[function]
pub fn side_by_side(values: &[i16; 4], others: &[i16; 5], key: i16) -> i32 {
    let doubled = values.iter().map(|value| i32::from(*value) * 2);
    let wanted = others.iter().filter(|other| **other > key);
    doubled.zip(wanted).map(|(value, other)| value ^ i32::from(*other)).sum()
}

/// A zip of three sequences.
#[function]
pub fn three(a: &[u8; 4], b: &[u8], c: &[u8; 3]) -> u32 {
    let both = a.iter().map(|x| x / 2).zip(b).zip(c.iter().copied());
    both.map(|((x, y), z)| u32::from(x) ^ u32::from(*y) << 8 ^ u32::from(z) << 16).sum()
}

/// Equality of the selected elements.
#[function]
pub fn same(values: &[i32; 3], others: &[i32; 4], part: u8) -> (bool, bool, bool) {
    let part = &others[..usize::from(part % 5)];
    let counted = others.iter().filter(|other| **other > 0);
    (
        values.iter().eq(part),
        values.iter().eq(counted),
        values.iter().map(|value| value / 2).ne(others[1..].iter().copied()),
    )
}
