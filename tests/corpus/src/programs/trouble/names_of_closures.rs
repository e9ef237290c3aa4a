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
