//! A closure passed to a function within a closure that is passed to the same function; and variables that such
//! closures assign.

use bessemer::prelude::*;

#[function]
fn visit<T: Copy, F: FnMut(T) -> bool>(first: T, second: T, mut visit: F) -> u8 {
    if visit(first) && visit(second) { 2 } else { 1 }
}

/// The inner call has another type.
#[function]
pub fn within(one: i32, other: u8) -> u8 {
    visit(one, 3, |x| visit(other, 4_u8, |y| y > 1) > 1 && x > 0)
}

/// Last value seen by a closure.
#[function]
pub fn last(one: i32, mut other: i32) -> (i32, i32, u8) {
    let mut last = 0;
    let seen = visit(one, other, |x| {
        last = x;
        other = 7;
        x > 1
    });
    (last, other, seen)
}

/// Nested closures that write an element and a variable.
#[function]
pub fn through(mut values: [i32; 3], mut at: i32) -> ([i32; 3], i32) {
    let part = &mut values[1];
    visit(at, 3, |x| {
        visit(x, 5, |y| {
            *part = y;
            at = x;
            y > 3
        }) > 1
    });
    (values, at)
}

/// A value assigned to itself: nothing changes.
#[function]
#[allow(dead_code)]
pub fn itself(mut value: u16) -> u16 {
    let mut kept = value;
    kept = kept;
    value = value;
    value ^ kept
}
