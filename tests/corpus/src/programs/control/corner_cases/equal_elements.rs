//! Minimum and maximum among equal elements that can be distinguished: `max` returns the last, `min` the first, by
//! `&`, by `&mut` and by value.

use bessemer::prelude::*;

/// A reading, compared by its key alone.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    pub key: u8,
    pub number: u8,
}

/// Readings with the given keys, numbered in order.
#[function]
fn readings(keys: [u8; 4]) -> [Reading; 4] {
    core::array::from_fn(|i| Reading { key: keys[i] % 2, number: i as u8 })
}

/// Marks the maximum through a mutable reference.
#[function]
pub fn greatest(keys: [u8; 4], n: usize) -> [u8; 4] {
    let mut all = keys.map(|key| key % 2);
    if let Some(x) = all[..n % 5].iter_mut().max() {
        *x = 9;
    }
    all
}

/// Marks the minimum through a mutable reference.
#[function]
pub fn least(keys: [u8; 4], n: usize) -> [u8; 4] {
    let mut all = keys.map(|key| key % 2);
    if let Some(x) = all[..n % 5].iter_mut().min() {
        *x = 9;
    }
    all
}

/// Marks minimum and maximum of a reversed iterator.
#[function]
pub fn from_the_end(keys: [u8; 4]) -> [u8; 4] {
    let mut all = keys.map(|key| key % 2);
    if let Some(x) = all.iter_mut().rev().max() {
        *x = 9;
    }
    *all.iter_mut().rev().min().unwrap() = 7;
    *all.iter_mut().skip(1).max().unwrap() ^= 4;
    all
}

/// Marks the readings found by a key and by a comparison.
#[function]
pub fn marked(keys: [u8; 4], n: usize) -> [Reading; 4] {
    let mut all = readings(keys);
    let some = &mut all[..n % 5];
    if let Some(it) = some.iter_mut().max_by_key(|it| it.key) {
        it.number ^= 16;
    }
    if let Some(it) = some.iter_mut().min_by_key(|it| it.key) {
        it.number ^= 32;
    }
    if let Some(it) = some.iter_mut().max_by(|one, other| one.key.cmp(&other.key)) {
        it.number ^= 64;
    }
    if let Some(it) = some.iter_mut().min_by(|one, other| one.key.cmp(&other.key)) {
        it.number ^= 128;
    }
    all
}

/// The numbers of the readings found by shared reference.
#[function]
pub fn by_reference(keys: [u8; 4], n: usize) -> [u8; 6] {
    let all = readings(keys);
    let some = &all[..n % 5];
    let compared = |one: &&Reading, other: &&Reading| one.key.cmp(&other.key);
    [
        some.iter().max_by_key(|it| it.key).map_or(9, |it| it.number),
        some.iter().min_by_key(|it| it.key).map_or(9, |it| it.number),
        some.iter().max_by(compared).map_or(9, |it| it.number),
        some.iter().min_by(compared).map_or(9, |it| it.number),
        some.iter().rev().max_by_key(|it| it.key).map_or(9, |it| it.number),
        some.iter()
            .reduce(|one, it| if it.key >= one.key { it } else { one })
            .map_or(9, |it| it.number),
    ]
}

/// The numbers of the readings found by value.
#[function]
pub fn by_value(keys: [u8; 4]) -> [u8; 5] {
    let all = readings(keys);
    [
        all.into_iter().max_by_key(|it| it.key).map_or(9, |it| it.number),
        all.into_iter().min_by_key(|it| it.key).map_or(9, |it| it.number),
        all.into_iter().max_by(|one, other| one.key.cmp(&other.key)).map_or(9, |it| it.number),
        all.into_iter().min_by(|one, other| one.key.cmp(&other.key)).map_or(9, |it| it.number),
        keys.iter().enumerate().max_by_key(|(_, key)| **key % 2).map_or(9, |(i, _)| i as u8),
    ]
}

/// Zeros of either sign are equal, but their sign shows which one was found.
#[function]
pub fn zeros(negative: [bool; 3]) -> [f64; 4] {
    let all = negative.map(|negative| if negative { -0.0 } else { 0.0 });
    let compared = |one: &f64, other: &f64| one.partial_cmp(other).unwrap();
    [
        all.into_iter().max_by(compared).unwrap_or(1.0),
        all.into_iter().min_by(compared).unwrap_or(1.0),
        all.iter().copied().max_by(compared).unwrap_or(1.0),
        all.iter().map(|x| -x).min_by(compared).unwrap_or(1.0),
    ]
}

/// Writes through the references that other methods find.
#[function]
pub fn found(keys: [u8; 4], n: usize) -> [u8; 4] {
    let mut all = keys.map(|key| key % 2);
    if let Some(x) = all.iter_mut().find(|x| **x == 1) {
        *x = 5;
    }
    if let Some(x) = all.iter_mut().rev().find(|x| **x == 0) {
        *x = 6;
    }
    if let Some(x) = all.iter_mut().nth(n % 5) {
        *x ^= 16;
    }
    if let Some(x) = all.iter_mut().last() {
        *x ^= 32;
    }
    all
}
