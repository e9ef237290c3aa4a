//! The name of a closure is free again where the closure is out of scope or hidden.

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

/// What a path names is handed on as it is, where closures have names, too.
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
