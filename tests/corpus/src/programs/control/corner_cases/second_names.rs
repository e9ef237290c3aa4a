//! Iterators under a second name, and next to the same names; own operators in closures; ranges as elements.

use core::ops::{Add, Range};

use bessemer::prelude::*;

/// A reference to an iterator under a name that is not `mut`.
#[function]
pub fn lent(values: &[u8; 8]) -> (Option<u8>, Option<u8>, usize) {
    let mut items = values.iter().copied();
    let bytes = &mut items;
    let first = bytes.next();
    (first, bytes.next(), bytes.count())
}

/// Searches by a method that takes the iterator by reference.
#[function]
pub fn by_method(values: &[u8; 8], end: u8) -> [Option<usize>; 3] {
    let mut parts = values.split(|byte| *byte == end);
    let left = parts.by_ref();
    core::array::from_fn(|_| left.next().map(|part| part.len()))
}

/// Binds its parameter to a second name.
#[function]
fn two(items: &mut impl Iterator<Item = u8>) -> u32 {
    let rest = items;
    let first = rest.next().map_or(256, u32::from);
    first.wrapping_mul(300).wrapping_add(rest.next().map_or(257, u32::from))
}

/// Passes the iterator by reference several times.
#[function]
pub fn again(values: &[u8; 8]) -> (u32, u32, u32, usize) {
    let mut items = values.iter().copied();
    let first = two(items.by_ref());
    let lent = &mut items;
    (first, two(lent), two(lent), items.count())
}

/// A chain on an iterator that is also read itself: each item is counted once.
#[function]
pub fn mapped(values: &[u8; 8], k: u8) -> ([Option<u8>; 4], usize) {
    let mut items = values.iter().copied();
    let mut turned = items.by_ref().map(|value| value ^ k);
    let (first, second) = (turned.next(), turned.next());
    let third = items.next();
    let mut rest = items.by_ref().filter(|value| *value > k);
    ([first, second, third, rest.next()], items.count())
}

/// Increments a count and returns it.
#[function]
fn counted_up(count: &mut u32) -> u32 {
    *count = count.wrapping_add(1) & 7;
    *count
}

/// An iterator whose end is computed when it is constructed.
#[function]
fn below(count: &mut u32) -> impl Iterator<Item = u32> + use<> {
    let start = *count & 1;
    (start..counted_up(count)).map(move |value| value ^ start)
}

/// Constructed once and advanced by `next`; a function's loop continues it.
#[function]
pub fn made_once(count: u32) -> ([Option<u32>; 4], u32) {
    let mut count = count;
    let mut items = below(&mut count);
    let taken = [items.next(), items.next(), items.next(), items.next()];
    (taken, count)
}

/// Ranges in an array, with an index that changes in the loop.
#[function]
pub fn wandering(ranges: &[core::ops::Range<u8>; 3]) -> u32 {
    let (mut at, mut digest) = (0_usize, 0_u32);
    for value in ranges[at].clone() {
        digest = digest.wrapping_mul(3).wrapping_add(u32::from(value));
        at = (at + 1) % 3;
    }
    digest
}

/// An iterator whose name hides another.
#[function]
pub fn shadowed(values: &[u8; 8], k: u8) -> u32 {
    let mut it = values.iter();
    let mut digest = 0_u32;
    for _ in 0..1 {
        let it = k;
        digest += u32::from(it);
    }
    for _ in 0..3 {
        digest = digest.wrapping_mul(31).wrapping_add(it.next().map_or(1, |value| u32::from(*value)));
    }
    digest
}

/// A struct that is not `Copy`.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    of: u32,
}

#[data]
impl Add<&Word> for Word {
    type Output = Word;

    fn add(self, other: &Word) -> Word {
        Word { of: self.of.wrapping_mul(31).wrapping_add(other.of) }
    }
}

/// A sum of words.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Digest(u32);

#[data]
impl From<&Word> for Digest {
    fn from(word: &Word) -> Digest {
        Digest(word.of)
    }
}

#[data]
impl From<Word> for Digest {
    fn from(word: Word) -> Digest {
        Digest(!word.of)
    }
}

/// A closure that moves its operand.
#[function]
pub fn folded(values: &[u32; 4]) -> [u32; 3] {
    let words = values.map(|of| Word { of });
    let sum = words.iter().fold(Word { of: 7 }, |sum, word| sum + word);
    let twice = Some(sum.clone()).map(|word| word + &sum).map_or(0, |word| word.of);
    [twice, Digest::from(&sum).0, Digest::from(sum).0]
}

/// Ranges as elements of an array.
#[function]
pub fn elements(ranges: &[core::ops::Range<u8>; 3], k: usize) -> u32 {
    let mut digest = 0_u32;
    let at = k % 3;
    for value in ranges[at].clone() {
        digest = digest.wrapping_mul(3).wrapping_add(u32::from(value));
    }
    for i in 0..3 {
        digest ^= ranges[i].clone().map(u32::from).sum::<u32>().rotate_left(i as u32);
    }
    let window: Range<u8> = ranges[2].clone();
    digest ^ u32::from(window.contains(&7))
}
