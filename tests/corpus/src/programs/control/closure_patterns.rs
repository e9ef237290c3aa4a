//! Closures destructure their arguments like any pattern: pairs, structs, references, `_`.

use bessemer::prelude::*;

/// A track with its quality.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Track {
    pub id: u16,
    pub score: f32,
}

/// The tracks that are good enough, as a bit mask.
#[function]
pub fn good(tracks: &[Track; 6], limit: f32) -> u8 {
    let mut bits = 0;
    for (i, track) in tracks.iter().enumerate().filter(|(_, track)| track.score > limit) {
        bits |= 1 << i;
        if track.id == 0 {
            break;
        }
    }
    bits
}

/// The first track after the index `after` that is good enough.
#[function]
pub fn next(tracks: &[Track; 6], after: usize, limit: f32) -> Option<usize> {
    tracks.iter().enumerate().find(|(i, track)| *i > after && track.score > limit).map(|(i, _)| i)
}

/// The sum of the products, where both are positive.
#[function]
pub fn together(a: &[i32; 4], b: &[i32; 4]) -> i64 {
    a.iter()
        .zip(b)
        .filter(|&(&x, &y)| x > 0 && y > 0)
        .map(|(x, y)| i64::from(*x) * i64::from(*y))
        .fold(0, |sum, product| sum ^ product)
}

/// The minimum and the maximum.
#[function]
pub fn ends(values: &[i32; 5]) -> (i32, i32) {
    values
        .iter()
        .fold((i32::MAX, i32::MIN), |(least, greatest), &x| (least.min(x), greatest.max(x)))
}

/// A named closure that takes a pair, and one that ignores its argument.
#[function]
pub fn scaled(pair: (i32, i32), other: (i32, i32)) -> i32 {
    let mixed = |(a, b): (i32, i32)| a ^ (b << 1);
    let fixed = |_: i32| 7;
    mixed(pair) ^ mixed(other) ^ fixed(pair.0)
}

/// Counts without reading the items.
#[function]
pub fn counted(value: Option<u8>, n: u8) -> (u8, u32, [u8; 3]) {
    (value.map_or(0, |_| 1), (0..n).map(|_| 2).sum(), core::array::from_fn(|_| n))
}
