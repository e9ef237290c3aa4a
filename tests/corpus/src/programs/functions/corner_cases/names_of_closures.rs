//! The name of a closure can be used again after its scope, or where it is hidden.

use bessemer::prelude::*;

#[function]
pub fn behind_its_scope(x: i32, up: bool) -> i32 {
    let first = {
        let step = |by: i32| x.wrapping_add(by);
        step(3)
    };
    let step = first.wrapping_mul(2);
    let last = if up {
        let first = |by: i32| by.wrapping_mul(step);
        first(x)
    } else {
        first
    };
    last.wrapping_sub(first)
}

#[function]
pub fn hidden(x: u8) -> u8 {
    let double = |n: u8| n.wrapping_mul(2);
    let double = double(x);
    match double {
        0 => 1,
        double => double ^ x,
    }
}

/// A path passed as a function means the item, even if a closure has the same name.
#[function]
pub fn beside_constants(x: u8, low: u8) -> Option<u8> {
    let far = |n: u8| n > low;
    if far(x) { Some(u8::MAX) } else { x.checked_add(i8::MAX as u8).or(None::<u8>) }
}

#[function]
pub fn behind_constants(x: i16, low: i16) -> i16 {
    let up = |n: i16| n.wrapping_sub(low);
    up(x).wrapping_add(i16::MIN).max(i16::MIN).min(i16::MAX)
}

/// Names in a closure keep the meaning that they have where it is written, whatever hides them later. That includes
/// calls from another closure, and passing the closure by name.
#[function]
pub fn hidden_later(x: i16, y: i16) -> i16 {
    let gain = x & 7;
    let scaled = |by: i16| by.wrapping_mul(gain);
    let r#gain = y & 3;
    let both = |by: i16| scaled(by).wrapping_add(gain);
    let first = both(scaled(y));
    let gain = first & 1;
    let known = Some(first).filter(|it| *it > gain).map(both).unwrap_or(gain);
    let all: [i16; 3] = core::array::from_fn(|at| scaled(at as i16));
    let last = [known, x].map(scaled);
    all[2].wrapping_add(last[0]).wrapping_sub(last[1]).wrapping_add(gain)
}

/// Each call sees the writes of the calls before it.
#[function]
pub fn counting(x: i16) -> [i16; 4] {
    let mut sum = x & 31;
    let mut next = |by: i16| {
        sum = sum.wrapping_mul(3).wrapping_add(by);
        sum
    };
    let first = next(1);
    let rest = next(first).wrapping_sub(next(2));
    [first, rest, next(rest), sum]
}
