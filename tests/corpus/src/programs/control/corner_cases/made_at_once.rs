//! An iterator is constructed where its expression is: computations before its first item, and copies, happen there.

use bessemer::prelude::*;

/// Increments a count; returns the new value.
#[function]
fn bump(count: &mut u32) -> u32 {
    *count = (*count & 7) + 1;
    *count
}

/// The numbers from one count to three beyond the next.
#[function]
fn counts(count: &mut u32) -> impl Iterator<Item = u32> + Clone + use<> {
    let start = bump(count);
    (start..bump(count) + 2).map(move |value| value ^ start)
}

/// Items multiplied by a key that is computed once.
#[function]
fn keyed<I: Iterator<Item = u32>>(items: I, count: &mut u32) -> impl Iterator<Item = u32> + use<I> {
    let key = bump(count);
    items.map(move |value| value ^ key)
}

/// The iterator is constructed before the initial value of the fold is evaluated.
#[function]
pub fn folded(count: u32) -> (u32, u32) {
    let mut count = count;
    let sum = counts(&mut count).fold(bump(&mut count), |sum, value| sum ^ value);
    (sum, count)
}

/// The iterator of a `try_fold` is constructed before the initial value, whatever it is.
#[function]
pub fn tried(values: [u32; 4], count: u32, kind: u8) -> (Option<u32>, u32) {
    let (mut values, mut count) = (values, count);
    let sum = match kind % 7 {
        0 => counts(&mut count).try_fold(bump(&mut count), |sum, value| sum.checked_add(value)),
        1 => values.map(|value| value ^ 1).iter().try_fold(
            {
                values[1] = count;
                bump(&mut count)
            },
            |sum: u32, value| sum.checked_add(*value),
        ),
        2 => [count, 7, count]
            .iter()
            .try_fold(bump(&mut count), |sum: u32, value| sum.checked_sub(*value)),
        3 => (Halves { left: count & 63 })
            .take(6)
            .try_fold(bump(&mut count), |sum: u32, value| sum.checked_sub(value)),
        4 => keyed(values.into_iter(), &mut count)
            .try_fold(bump(&mut count), |sum: u32, value| sum.checked_add(value)),
        5 => values.into_iter().skip(count as usize & 3).try_fold(
            {
                values = [9; 4];
                bump(&mut count)
            },
            |sum: u32, value| sum.checked_add(value),
        ),
        _ => (count..count.saturating_add(3)).chain(values).try_fold(
            {
                values[0] = 1;
                bump(&mut count)
            },
            |sum: u32, value| sum.checked_add(value),
        ),
    };
    (sum, count ^ values[0] ^ values[1])
}

/// A named iterator is constructed before the statements that follow.
#[function]
pub fn named(count: u32) -> (u32, u32) {
    let mut count = count;
    let odd = counts(&mut count).filter(|value| *value & 1 == 1);
    let between = bump(&mut count);
    let sum = odd.clone().fold(between, |sum, value| sum.wrapping_mul(3) ^ value);
    (odd.fold(sum, |sum, value| sum.wrapping_mul(5) ^ value), count)
}

/// An iterator constructed once, and advanced by `next`.
#[function]
pub fn by_hand(count: u32) -> (u32, Option<u32>, u32) {
    let mut count = count;
    let mut items = counts(&mut count);
    let between = bump(&mut count);
    let first = items.next().unwrap_or(bump(&mut count));
    let second = items.next();
    (items.fold(first ^ between, |sum, value| sum ^ value), second, count)
}

/// An iterator constructed as an argument of a function that iterates over it.
#[function]
pub fn through(count: u32, other: u32, values: &[u32; 3]) -> (u32, u32, u32) {
    let (mut count, mut other) = (count, other);
    let all = keyed(counts(&mut count), &mut other).chain(values.iter().copied());
    let between = bump(&mut count) ^ bump(&mut other);
    (all.fold(between, |sum, value| sum.wrapping_mul(3) ^ value), count, other)
}

/// Two iterators constructed from left to right, and compared.
#[function]
pub fn same(count: u32) -> (bool, u32) {
    let mut count = count;
    let same = counts(&mut count).eq(counts(&mut count));
    (same, count)
}

/// An iterator whose construction may fault, even if no item is requested.
#[function]
fn parts(of: u32) -> impl Iterator<Item = u32> {
    let step = 1000 / of;
    (0..3).map(move |part| part * step)
}

/// The construction's fault comes before that of the index.
#[function]
pub fn unwanted(of: u32, values: &[u32; 4], at: usize) -> u32 {
    let all = parts(of);
    let value = values[at];
    if value > 100 {
        return value;
    }
    all.fold(value, |sum, part| sum ^ part)
}

/// Repeated halves of a number, until zero.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Halves {
    left: u32,
}

#[data]
impl Iterator for Halves {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        if self.left == 0 {
            return None;
        }
        self.left /= 2;
        Some(self.left)
    }
}

/// A clone of a chain advances independently of the original.
#[function]
pub fn copied(left: u32) -> (u32, u32, u32) {
    let all = Halves { left }.take(5).map(|value| value ^ 3);
    let twice = all.clone().map(|value| value ^ 5);
    let sum = all.clone().fold(0, |sum: u32, value| sum.wrapping_mul(3) ^ value);
    let next = twice.clone().fold(sum, |sum, value| sum.wrapping_mul(3) ^ value);
    (next, twice.count() as u32, all.fold(7, |sum: u32, value| sum.wrapping_mul(5) ^ value))
}

/// A chain on top of it, of which a few items are taken.
#[function]
pub fn changed(left: u32, key: u32) -> u32 {
    let mut sum = 0_u32;
    for value in (Halves { left }).map(|value| value ^ key).take(4) {
        sum = sum.wrapping_mul(3) ^ value;
    }
    let named = Halves { left: left ^ key }.inspect(|_| {}).map(|value| value ^ 1);
    named.take(6).fold(sum, |sum, value| sum.wrapping_mul(3) ^ value)
}

/// That chain advanced by `next`, and a clone of it.
#[function]
pub fn changed_by_hand(left: u32) -> ([Option<u32>; 4], u32) {
    let mut items = Halves { left }.map(|value| value ^ 6);
    let (first, mut copy) = (items.next(), items.clone());
    let (second, third) = (items.next(), copy.next());
    let rest = items.by_ref().take(2).fold(0, |sum: u32, value| sum.wrapping_mul(3) ^ value);
    ([first, second, third, items.next()], rest ^ copy.take(3).sum::<u32>())
}

/// A loop over one item.
#[function]
pub fn once(value: i16, key: i16) -> (i16, i16) {
    let mut digest = value;
    loop {
        if digest > key {
            break;
        }
        digest ^= 5;
        if digest == 3 {
            digest = 8;
            break;
        }
        digest ^= key;
        break;
    }
    let chosen = loop {
        if value > 3 {
            break 7;
        }
        if key == digest {
            break 5;
        }
        break value ^ key;
    };
    (digest, chosen)
}

/// Alternatives of a pattern that bind the same names.
#[function]
pub fn alternatives(of: Option<i16>, key: i16) -> (i16, i16) {
    let mut key = key;
    let step = |key: &mut i16| {
        *key = (*key & 15) ^ 9;
        *key
    };
    let ends = (0..match of {
        Some(value @ 1 | value @ (3..=60 | -9)) if value > step(&mut key) => value & 7,
        value @ Some(_) => value.unwrap_or(1) & 3,
        None => 2,
    })
        .map(|value| value ^ 3)
        .fold(1, |sum: i16, value| sum.wrapping_mul(3) ^ value);
    (ends, key)
}

/// A size of zero faults when the iterator is constructed, even if no item is requested.
#[function]
pub fn sizes(values: &[u32; 4], size: usize, at: usize, kind: u8) -> u32 {
    let size = size & 3;
    let parts = match kind & 3 {
        0 => {
            let parts = values.chunks(size);
            if values[at] & 1 == 1 {
                return 1;
            }
            parts.count()
        }
        1 => {
            let parts = values.iter().step_by(size);
            if values[at] & 1 == 1 {
                return 2;
            }
            parts.count()
        }
        2 => {
            let parts = values.iter().filter(|value| **value & 2 == 0).step_by(size);
            if values[at] & 1 == 1 {
                return 3;
            }
            parts.count()
        }
        _ => (0..values.len()).step_by(size).filter(|place| *place != at).count(),
    };
    parts as u32
}

/// The rest of an iterator, and a clone of an adapter of it.
#[function]
pub fn rest(values: &[u32; 6], key: u32) -> [u32; 3] {
    let mut items = values.iter().copied();
    let first = items.next().unwrap_or(1);
    let rest = items.map(move |value| value ^ key);
    let sum = rest.clone().fold(0, |sum: u32, value| sum.wrapping_mul(3) ^ value);
    [first, sum, rest.fold(1, |sum: u32, value| sum.wrapping_mul(5) ^ value)]
}

/// Returns its iterator unchanged.
#[function]
fn passed<I: Iterator<Item = u32>>(items: I) -> impl Iterator<Item = u32> {
    items
}

/// An iterator that a function returns, advanced by `next`.
#[function]
pub fn handed(values: &[u32; 6]) -> ([Option<u32>; 3], u32) {
    let mut items = values.iter().copied();
    let (first, second) = {
        let mut some = passed(items.by_ref());
        (some.next(), some.next())
    };
    ([first, second, items.next()], items.fold(0, |sum: u32, value| sum.wrapping_mul(3) ^ value))
}
