//! Adapters in any order: the type of an adapter's receiver decides which one it is.

use bessemer::prelude::*;

/// Skips, reverses and enumerates elements: combination 1.
#[function]
pub fn through(v: &[u16; 5], n: usize) -> u32 {
    let mut s = 7u32;
    for (i, x) in v.iter().rev().skip(n % 4).enumerate() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x) ^ i as u32);
    }
    s
}

/// Skips, reverses and enumerates elements: combination 2.
#[function]
pub fn through_one(v: &[u16; 5], n: usize) -> u32 {
    let mut s = 7u32;
    for (i, x) in v.iter().enumerate().rev().skip(n % 7) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x) ^ i as u32);
    }
    s
}

/// Skips, reverses and enumerates elements: combination 3.
#[function]
pub fn through_two(v: &[u16; 5], n: usize) -> u32 {
    let mut s = 7u32;
    for (i, x) in v.iter().skip(n % 7).rev().take(2).enumerate() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x) ^ i as u32);
    }
    s
}

/// Skips, reverses and enumerates elements: combination 4.
#[function]
pub fn through_three(v: &[u16; 5], n: usize) -> u32 {
    let mut s = 7u32;
    for (x, i) in v.iter().zip(0..n % 9) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x) ^ i as u32);
    }
    s
}

/// Skips, reverses and enumerates elements: combination 5.
#[function]
pub fn through_four(v: &[u16; 5], a: i8, b: i8) -> i32 {
    let mut s = 7i32;
    for (i, x) in (a..b).zip(v) {
        s = s.wrapping_mul(31).wrapping_add(i32::from(*x) ^ i32::from(i));
    }
    s
}

/// Skips, reverses and enumerates elements: combination 6.
#[function]
pub fn through_five(v: &[u16; 5], a: i8, b: i8) -> i32 {
    let mut s = 7i32;
    for (x, i) in v.iter().zip(a..=b) {
        s = s.wrapping_mul(31).wrapping_add(i32::from(*x) ^ i32::from(i));
    }
    s
}

/// Adapters on a range: combination 1.
#[function]
pub fn ranges(a: i16, b: i16) -> i32 {
    let mut s = 7i32;
    for (i, x) in (a.max(-50)..b.min(70)).enumerate() {
        s = s.wrapping_mul(31).wrapping_add(i32::from(x) ^ i as i32);
    }
    s
}

/// Adapters on a range: combination 2.
#[function]
pub fn ranges_one(a: u8, b: u8) -> u32 {
    let mut s = 7u32;
    for x in (a..b).skip(2).take(9) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(x));
    }
    s
}

/// Adapters on a range: combination 3.
#[function]
pub fn ranges_two(a: u8, b: u8) -> u32 {
    let mut s = 7u32;
    for x in (a..=b).rev().step_by(3) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(x));
    }
    s
}

/// Adapters on a range: combination 4.
#[function]
pub fn ranges_three(a: u8, b: u8, k: u8) -> u32 {
    let mut s = 7u32;
    for x in (a..=b).step_by(usize::from(k % 5) + 1).rev() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(x));
    }
    s
}

/// Adapters on a range: combination 5.
#[function]
pub fn ranges_four(a: u8, b: u8, k: u8) -> u32 {
    let mut s = 7u32;
    for (i, x) in (a..b).rev().step_by(usize::from(k % 5) + 1).enumerate() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(x) ^ i as u32);
    }
    s
}

/// Adapters on a range: combination 6.
#[function]
pub fn ranges_five(n: u8) -> u32 {
    (0..n)
        .enumerate()
        .map(|(i, x)| i as u32 ^ (u32::from(x) << 3))
        .fold(1, |a, x| a * 5 % 65521 + x)
}

/// Adapters on a range: combination 7.
#[function]
pub fn ranges_six(a: i8, b: i8) -> i32 {
    let mut s = 7i32;
    for (x, y) in (a..b).zip((a..b).rev()) {
        s = s.wrapping_mul(31).wrapping_add(i32::from(x) ^ (i32::from(y) << 2));
    }
    s
}

/// Adapters on chunks and windows: combination 1.
#[function]
pub fn groups(v: &[u8; 7], n: usize) -> u32 {
    let mut s = 7u32;
    for (i, pair) in v.windows(2).rev().enumerate() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(pair[0]) ^ u32::from(pair[1]) << i);
    }
    s.wrapping_add(n as u32)
}

/// Adapters on chunks and windows: combination 2.
#[function]
pub fn groups_one(v: &[u8; 7], n: usize) -> u32 {
    let mut s = 7u32;
    for part in v.chunks(n % 4 + 1).skip(1) {
        for x in part {
            s = s.wrapping_mul(31).wrapping_add(u32::from(*x));
        }
        s += part.len() as u32;
    }
    s
}

/// Adapters on chunks and windows: combination 3.
#[function]
pub fn groups_two(v: &[u8; 7], n: usize) -> u32 {
    let mut s = 7u32;
    for part in v.chunks(n % 4 + 1).rev().step_by(2) {
        for x in part {
            s = s.wrapping_mul(31).wrapping_add(u32::from(*x));
        }
        s += part.len() as u32;
    }
    s
}

/// Adapters on chunks and windows: combination 4.
#[function]
pub fn groups_three(v: &[u8; 7], n: usize) -> u32 {
    let mut s = 7u32;
    for (part, x) in v.chunks_exact(2).rev().zip(v.iter().skip(n % 8).rev()) {
        s = s
            .wrapping_mul(31)
            .wrapping_add(u32::from(part[0]) ^ u32::from(part[1]) << 1 ^ u32::from(*x) << 4);
    }
    s
}

/// Adapters on chunks and windows: combination 5.
#[function]
pub fn groups_four(v: &[u8; 7], n: usize) -> u32 {
    let mut s = 7u32;
    for (i, part) in v.chunks_exact(n % 3 + 1).enumerate().rev().skip(1) {
        s = s
            .wrapping_mul(31)
            .wrapping_add(part.iter().map(|x| u32::from(*x)).sum::<u32>() ^ i as u32);
    }
    s
}

/// Adapters on chunks and windows: combination 6.
#[function]
pub fn groups_five(v: &[u8; 7]) -> u32 {
    let mut s = 7u32;
    for part in v.chunks_exact(3).step_by(2) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(part[0]));
    }
    for part in v.chunks(3).take(2).rev() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(part[0]));
    }
    s
}

/// Nested zips and cycles: combination 1.
#[function]
pub fn pairs(v: &[i16; 5], w: &[i16; 3], n: usize) -> i32 {
    let mut s = 7i32;
    for ((i, x), y) in v.iter().enumerate().zip(w) {
        s = s.wrapping_mul(31).wrapping_add(i32::from(*x) ^ i32::from(*y) << i);
    }
    for (x, (i, y)) in v.iter().zip(w.iter().enumerate().rev()) {
        s = s.wrapping_mul(31).wrapping_add(i32::from(*x) ^ i32::from(*y) << i);
    }
    s.wrapping_add(n as i32)
}

/// Nested zips and cycles: combination 2.
#[function]
pub fn pairs_one(v: &[i16; 5], w: &[i16; 3], n: usize) -> i32 {
    let mut s = 7i32;
    for (i, (x, y)) in v.iter().zip(w.iter().cycle()).enumerate() {
        s = s.wrapping_mul(31).wrapping_add(i32::from(*x) ^ i32::from(*y) << i);
    }
    s.wrapping_add(n as i32)
}

/// Nested zips and cycles: combination 3.
#[function]
pub fn pairs_two(v: &[i16; 5], w: &[i16; 3], n: usize) -> i32 {
    let mut s = 7i32;
    for (i, x) in v.iter().rev().chain(w.iter()).skip(n % 9).enumerate() {
        s = s.wrapping_mul(31).wrapping_add(i32::from(*x) ^ i as i32);
    }
    s
}

/// Nested zips and cycles: combination 4.
#[function]
pub fn pairs_three(v: &[i16; 5], w: &[i16; 3], n: usize) -> i32 {
    let mut s = 7i32;
    for (x, y) in v.iter().chain(w.iter()).zip(v.iter().chain(w.iter()).rev()).skip(n % 9) {
        s = s.wrapping_mul(31).wrapping_add(i32::from(*x) ^ i32::from(*y) << 1);
    }
    s
}

/// Nested zips and cycles: combination 5.
#[function]
pub fn pairs_four(v: &[i16; 5], w: &[i16; 3], n: usize) -> i32 {
    let mut s = 7i32;
    for x in v.iter().chain(w.iter().rev()).step_by(n % 3 + 1) {
        s = s.wrapping_mul(31).wrapping_add(i32::from(*x));
    }
    s
}

/// Nested zips and cycles: combination 6.
#[function]
pub fn pairs_five(v: &[i16; 5], w: &[i16; 3], n: usize) -> i32 {
    let mut s = 7i32;
    for x in w.iter().cycle().take(n % 11) {
        s = s.wrapping_mul(31).wrapping_add(i32::from(*x));
    }
    for x in w.iter().cycle().skip(2).take(n % 11) {
        s = s.wrapping_mul(31).wrapping_add(i32::from(*x));
    }
    s.wrapping_add(i32::from(v[0]))
}

/// Elements that are written during the iteration: combination 1.
#[function]
pub fn written(v: &mut [i16; 6], n: usize) -> i32 {
    for (i, x) in v.iter_mut().rev().skip(n % 7).enumerate() {
        *x = x.wrapping_mul(3).wrapping_add(i as i16);
    }
    for (i, x) in v.iter_mut().step_by(2).rev().enumerate() {
        *x = x.wrapping_mul(3).wrapping_add(i as i16);
    }
    v.iter().fold(1i32, |a, x| a.wrapping_mul(31).wrapping_add(i32::from(*x)))
}

/// Elements that are written during the iteration: combination 2.
#[function]
pub fn written_one(v: &mut [i16; 6], n: usize) -> i32 {
    for (part, i) in v.chunks_mut(n % 4 + 1).zip(3i16..) {
        for x in part {
            *x = x.wrapping_add(i);
        }
    }
    for (part, i) in v.chunks_exact_mut(2).rev().zip(-3i16..=4) {
        part[1] = part[0].wrapping_mul(i);
    }
    v.iter().fold(1i32, |a, x| a.wrapping_mul(31).wrapping_add(i32::from(*x)))
}

/// Elements that are written during the iteration: combination 3.
#[function]
pub fn written_two(v: [i16; 6], n: usize) -> i32 {
    let mut v = v;
    let mut s = 1i32;
    for (i, x) in v.into_iter().rev().enumerate() {
        v[i] = x.wrapping_add(n as i16);
        s = s.wrapping_mul(31).wrapping_add(i32::from(x));
    }
    for (i, x) in v.into_iter().enumerate().skip(n % 7) {
        v[(i + 1) % 6] = x.wrapping_add(n as i16);
        s = s.wrapping_mul(31).wrapping_add(i32::from(x));
    }
    v.iter().fold(s, |a, x| a.wrapping_mul(31).wrapping_add(i32::from(*x)))
}

/// Elements that are written during the iteration: combination 4.
#[function]
pub fn written_three(v: [i16; 6], n: usize) -> i32 {
    let mut v = v;
    let mut s = 1i32;
    for (x, y) in v.into_iter().skip(n % 3).zip(v.into_iter().rev()) {
        v[2] = x.wrapping_add(y);
        v[4] = 3;
        s = s.wrapping_mul(31).wrapping_add(i32::from(x) ^ i32::from(y) << 1);
    }
    v.iter().fold(s, |a, x| a.wrapping_mul(31).wrapping_add(i32::from(*x)))
}

/// Adapters advanced by `next` calls: combination 1.
#[function]
pub fn hands(v: &[u8; 6], n: usize) -> u32 {
    let mut it = v.iter().rev().enumerate();
    let mut s = 0u32;
    if let Some((i, x)) = it.next() {
        s = u32::from(*x) ^ i as u32;
    }
    for (i, x) in it.by_ref() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x) << i);
        if i == n % 5 {
            break;
        }
    }
    if let Some((i, x)) = it.next() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x) ^ i as u32);
    }
    s
}

/// Adapters advanced by `next` calls: combination 2.
#[function]
pub fn hands_one(v: &[u8; 6], n: usize) -> u32 {
    let mut it = v.iter().skip(n % 4).zip(5u32..);
    let mut s = 0u32;
    if let Some((x, i)) = it.next() {
        s = u32::from(*x) ^ i;
    }
    for (x, i) in it {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x) << (i % 8));
    }
    s
}

/// Adapters advanced by `next` calls: combination 3.
#[function]
pub fn hands_two(n: u8) -> u32 {
    let mut it = (3..n % 9).step_by(2);
    let mut s = 0u32;
    while let Some(x) = it.next() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(x));
        if x > 5 {
            break;
        }
    }
    s + it.next().map_or(0, u32::from)
}

/// Adapters advanced by `next` calls: combination 4.
#[function]
pub fn hands_three(v: &[u8; 6], n: usize) -> u32 {
    let mut it = v.iter().step_by(n % 3 + 1).rev();
    let a = it.next().copied().unwrap_or(0);
    let b = it.next().copied().unwrap_or(0);
    u32::from(a) << 9 | u32::from(b)
}

/// Closures between adapters: combination 1.
#[function]
pub fn chained(v: &[u8; 6], n: usize) -> Option<(usize, u8)> {
    v.iter().copied().enumerate().rev().skip(n % 5).max_by_key(|(i, x)| *x ^ *i as u8)
}

/// Closures between adapters: combination 2.
#[function]
pub fn chained_one(v: &[u8; 6], n: usize) -> u32 {
    v.iter()
        .map(|x| x.wrapping_mul(3))
        .enumerate()
        .skip(n % 5)
        .map(|(i, x)| u32::from(x) << i)
        .sum()
}

/// Closures between adapters: combination 3.
#[function]
pub fn chained_two(v: &[u8; 6], n: usize) -> u32 {
    v.iter()
        .map(|x| x.wrapping_mul(3))
        .rev()
        .enumerate()
        .filter(|(i, _)| *i != n % 6)
        .map(|(i, x)| u32::from(x) << i)
        .sum()
}

/// Closures between adapters: combination 4.
#[function]
pub fn chained_three(v: &[u8; 6], n: usize) -> u32 {
    v.iter()
        .filter(|x| usize::from(**x) > n % 200)
        .enumerate()
        .map(|(i, x)| u32::from(*x) << i)
        .sum()
}

/// Closures between adapters: combination 5.
#[function]
pub fn chained_four(v: &[u8; 6], n: usize) -> u32 {
    let mut s = 3u32;
    for (i, (j, x)) in v.iter().enumerate().map(|(i, x)| (i * 2, *x)).rev().enumerate() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(x) ^ (i * 10 + j) as u32);
    }
    s + n as u32 % 7
}

/// Closures between adapters: combination 6.
#[function]
pub fn chained_five(v: &[u8; 6], n: usize) -> u32 {
    let mut s = 3u32;
    for (i, (j, (k, x))) in v.iter().enumerate().rev().enumerate().skip(n % 3).rev().enumerate() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x) ^ (i * 100 + j * 10 + k) as u32);
    }
    s
}

/// Closures between adapters: combination 7.
#[function]
pub fn chained_six(v: &[u8; 6], n: usize) -> u32 {
    let mut s = 3u32;
    for (mut i, x) in v.iter().enumerate() {
        i += n % 3;
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x) ^ i as u32);
    }
    for (mut i, x) in (0..).zip(v) {
        i += n % 3;
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x) ^ i as u32);
    }
    for mut i in 0..n % 9 {
        i *= 2;
        s = s.wrapping_mul(31).wrapping_add(i as u32);
    }
    for mut i in (0..n % 9).step_by(2) {
        i *= 2;
        s = s.wrapping_mul(31).wrapping_add(i as u32);
    }
    s
}

/// Ranges with and without an end: combination 1.
#[function]
pub fn open(v: &[u8; 5], a: u8) -> u32 {
    let mut s = 3u32;
    for (i, x) in (a..).zip(v) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x ^ i));
    }
    s
}

/// Ranges with and without an end: combination 2.
#[function]
pub fn open_one(v: &[u8; 5], a: u8) -> u32 {
    let mut s = 3u32;
    for (x, i) in v.iter().zip(a..) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x ^ i));
    }
    for (x, i) in v.iter().zip(251u8..) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x ^ i));
    }
    s
}

/// Ranges with and without an end: combination 3.
#[function]
pub fn open_two(v: &[u8; 5], a: u8, b: u8) -> u32 {
    let mut s = 3u32;
    for ((x, i), j) in v.iter().zip(a..).zip(b..=200) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x ^ i ^ j << 1));
    }
    s
}

/// Ranges with and without an end: combination 4.
#[function]
pub fn open_three(v: &[u8; 5], a: u8, b: u8) -> u32 {
    let mut s = 3u32;
    for (j, (i, x)) in (b..b.saturating_add(3)).zip((a..).zip(v)) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x ^ i ^ j << 1));
    }
    s
}

/// Ranges with and without an end: combination 5.
#[function]
pub fn open_four(v: &[u8; 5], a: u8) -> u32 {
    let mut s = 3u32;
    for (n, (i, x)) in (a..).zip(v).enumerate() {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x ^ i) + n as u32);
    }
    for (x, i) in v.iter().zip(a..).take(2) {
        s = s.wrapping_mul(31).wrapping_add(u32::from(*x ^ i));
    }
    s
}
