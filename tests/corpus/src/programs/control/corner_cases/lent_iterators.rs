//! Iterators passed to functions by reference: `bytes: &mut impl Iterator<Item = u8>`. A function takes some items
//! and leaves the others.

use bessemer::prelude::*;

/// Reads a number of seven bits per byte; the top bit of its last byte is clear.
#[function]
fn number(bytes: &mut impl Iterator<Item = u8>) -> Option<u32> {
    let mut value = 0;
    for shift in (0..28).step_by(7) {
        let byte = bytes.next()?;
        value |= u32::from(byte & 0x7f) << shift;
        if byte & 0x80 == 0 {
            return Some(value);
        }
    }
    None
}

/// Passes its iterator on to other calls, as it is and by a new reference.
#[function]
fn two<I>(bytes: &mut I) -> Option<u32>
where
    I: Iterator<Item = u8>,
{
    Some(number(bytes)? ^ number(&mut *bytes)?.rotate_left(1))
}

/// Sum of the items that follow; the first item is their number.
#[function]
fn rest(bytes: &mut impl Iterator<Item = u8>, most: usize) -> u32 {
    let mut sum = 0_u32;
    for byte in bytes.by_ref().take(most) {
        sum = sum.wrapping_mul(31).wrapping_add(u32::from(byte));
    }
    sum
}

/// Reads a line through one iterator after the other.
#[function]
pub fn read(line: &[u8]) -> Option<(u32, u32, u32, usize)> {
    let mut bytes = line.iter().copied();
    let first = number(&mut bytes)?;
    let next = bytes.next()?;
    let both = two(&mut bytes)?;
    let sum = rest(&mut bytes, 2) ^ u32::from(next);
    Some((first, both, sum, bytes.count()))
}

/// Passes an iterator without a name by reference.
#[function]
pub fn unnamed(line: &[u8; 6], key: u8) -> Option<u32> {
    two(&mut line.iter().map(|byte| byte ^ key))
}

/// A loop that takes its items by a call.
#[function]
pub fn all(line: &[u8; 9]) -> u32 {
    let mut bytes = line.iter().copied().filter(|byte| *byte != 0xff);
    let mut digest = 3_u32;
    while let Some(kind) = bytes.next() {
        digest = digest.rotate_left(5)
            ^ match kind & 3 {
                0 => number(&mut bytes).unwrap_or(1000),
                1 => rest(&mut bytes, usize::from(kind >> 6)),
                _ => u32::from(kind),
            };
    }
    digest
}

/// Bytes from a recurrence.
#[data]
#[derive(Clone, Debug)]
pub struct Noise {
    state: u8,
}

#[data]
impl Iterator for Noise {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        self.state = self.state.wrapping_mul(29).wrapping_add(101);
        (self.state != 0).then_some(self.state)
    }
}

/// Passes an author's own iterator by reference.
#[function]
pub fn own(seed: u8) -> (Option<u32>, u32, u8) {
    let mut noise = Noise { state: seed };
    let first = two(&mut noise);
    let sum = rest(&mut noise, 3);
    (first, sum, noise.state)
}
