//! `&` and `&mut` of a value without a place: the value gets one, which lives as long as the name.

use bessemer::prelude::*;

/// A point.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Marker {
    pub x: u32,
    pub y: [u32; 2],
}

/// Later writes to `x` do not reach what was computed of it.
#[function]
pub fn shared(mut x: u32) -> u32 {
    let sum = &(x ^ 9);
    let literal = &7u32;
    let row = &[x, 2, 3];
    let copied = &{ x };
    let narrow = &(x as u8);
    let chosen = &if x > 5 { x } else { 4 };
    let matched = &match x % 3 {
        0 => x,
        left => left + 10,
    };
    let spot = &Marker { x, y: [x, 1] };
    let field = &Marker { x, y: [3, x] }.y;
    let element = &[x, 8][1];
    let optional = &Some(x);
    let word = b"ab";
    let both = &(x, 3u8);
    x = x.wrapping_add(1);
    let first = sum ^ literal ^ row[0] ^ row[(x % 3) as usize] ^ copied.rotate_left(3) ^ u32::from(*narrow);
    let second = chosen ^ matched ^ spot.x ^ spot.y[0] ^ field[1].rotate_left(5) ^ element;
    let third = optional.unwrap_or(1) ^ u32::from(word[(x % 2) as usize]) ^ both.0 ^ u32::from(both.1);
    first ^ second.rotate_left(7) ^ third.rotate_left(14) ^ x
}

/// Writes reach the value, and nothing that it was computed of.
#[function]
pub fn exclusive(x: u32) -> u32 {
    let sum = &mut (x ^ 9);
    *sum = sum.wrapping_add(x);
    let copied = &mut { x };
    *copied ^= 3;
    let row = &mut [x, 2, 3];
    row[(x % 3) as usize] ^= *copied;
    row.swap(0, 1);
    let spot = &mut Marker { x, y: [x, 1] };
    spot.y[1] = spot.x.wrapping_mul(3);
    let field = &mut Marker { x, y: [3, x] }.x;
    core::mem::swap(field, sum);
    let optional = &mut Some(x);
    if let Some(inner) = optional {
        *inner = inner.rotate_left(2);
    }
    let taken = optional.take().unwrap_or(0);
    *sum ^ field.rotate_left(3) ^ row[0].rotate_left(6) ^ row[1] ^ spot.y[1] ^ taken ^ copied.rotate_left(9) ^ x
}

/// Each pass has values of its own.
#[function]
pub fn repeated(x: u32) -> u32 {
    let mut sum = x;
    for k in 0..4u32 {
        let count = &mut k.wrapping_mul(sum);
        let limit = &(sum % 5 + 1);
        *count = count.wrapping_add(1);
        sum = sum.wrapping_add(*count % limit);
    }
    sum
}

/// Calls both.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReferencesToValues {
    last: u32,
}

#[component]
impl ReferencesToValues {
    /// Returns both.
    #[entry(infallible)]
    pub fn step(&mut self, x: u32) -> u32 {
        let before = &self.last.wrapping_add(x);
        self.last = shared(*before) ^ exclusive(x).rotate_left(1) ^ repeated(x % 1000);
        self.last ^ before
    }
}
