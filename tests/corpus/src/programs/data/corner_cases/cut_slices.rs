//! Slices split into parts by `split` and similar methods. The parts are used in loops, in chains and by explicit
//! `next` calls, some of which continue in a loop.

use bessemer::prelude::*;

/// The sum of the numbers in a line, or `None` if one of them has more than one invalid digit.
#[function]
pub fn summed(line: &[u8]) -> Option<u32> {
    let mut sum = 0_u32;
    for field in line.split(|byte| *byte == b',') {
        let mut number = 0_u32;
        for digit in field {
            number = number.checked_mul(10)?.checked_add(u32::from(digit.checked_sub(b'0')?))?;
        }
        sum = sum.wrapping_add(number);
    }
    Some(sum)
}

/// Parts of a split in chains.
#[function]
pub fn chained(line: &[u8; 9], end: u8) -> [usize; 5] {
    let short = line.split(|byte| byte & 3 == end & 3).filter(|part| part.len() < 3).count();
    let second = line.split(|byte| *byte > end).nth(1).map_or(99, |part| part.len());
    let rising = line.chunk_by(|a, b| a <= b).map(|run| run.len()).max().unwrap_or(0);
    let whole = line.split_inclusive(|byte| byte & 1 == 1).count();
    let last = line.split_inclusive(|byte| byte & 1 == 1).last().map_or(0, |part| part.len());
    [short, second, rising, whole, last]
}

/// The number of parts of an empty slice: one for `split`, none for `split_inclusive`.
#[function]
pub fn empty(line: &[u8]) -> (usize, usize, usize) {
    let none = &line[..line.len().min(1) / 2];
    (
        none.split(|_| true).count(),
        none.split_inclusive(|_| true).count(),
        none.chunk_by(|_, _| true).count(),
    )
}

/// Parts taken by `next`, with a clone that advances independently, one in a loop, and the rest.
#[function]
pub fn by_hand(line: &[u8]) -> Option<[usize; 5]> {
    let mut fields = line.split(|byte| *byte & 7 == 0);
    let first = fields.next()?;
    let mut others = fields.clone();
    let left = fields.clone().count();
    let second = fields.next()?;
    let other = others.next()?;
    let rest: usize = fields.map(|field| field.len()).sum();
    Some([first.len(), left, second.len(), other.len(), rest])
}

/// Bytes with escape sequences.
#[function]
pub fn unescaped(frame: &[u8; 8], open: u8) -> Option<(u32, usize)> {
    let mut bytes = frame.iter();
    let (mut sum, mut count) = (0_u32, 0);
    while let Some(&byte) = bytes.next() {
        if byte == open {
            continue;
        }
        let value = if byte & 1 == 1 { bytes.next()? ^ 0x20 } else { byte };
        if value == 0x55 {
            break;
        }
        sum = sum.wrapping_mul(31).wrapping_add(u32::from(value));
        count += 1;
    }
    Some((sum, count + bytes.count()))
}

/// Pairs among the remaining items of a chain, up to an item that is none.
#[function]
pub fn pairs(values: &[i16]) -> i32 {
    let mut odd = values.iter().filter(|value| **value & 1 == 1).map(|value| i32::from(*value));
    let mut sum = 0_i32;
    'pairs: while let Some(first @ 1..) = odd.next() {
        let mut most = first;
        for _ in 0..2 {
            match odd.next() {
                Some(next) => most = most.max(next),
                None => break 'pairs,
            }
        }
        sum = sum.wrapping_add(most);
    }
    sum
}

/// Splits the parts of a split again.
#[function]
pub fn nested(text: &[u8; 10]) -> u32 {
    let mut lines = text.split(|byte| *byte & 15 == 10);
    let mut digest = 5_u32;
    while let Some(line) = lines.next() {
        let mut words = line.split(|byte| *byte & 15 == 2);
        while let Some(word) = words.next() {
            digest = digest.rotate_left(5) ^ word.len() as u32;
            if word.is_empty() && words.next().is_none() {
                digest = digest.wrapping_add(lines.next().map_or(1, |line| line.len() as u32));
            }
        }
    }
    digest
}
