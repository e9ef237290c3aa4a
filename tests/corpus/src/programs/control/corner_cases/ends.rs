//! Loops whose end is converted from another type.

use bessemer::prelude::*;

#[function]
pub fn to_narrow(n: u8) -> u32 {
    let mut sum = 0;
    for i in 1..=u32::from(n) {
        sum += i;
    }
    sum
}

/// −1 is the largest `u8`: the loop runs to the end of its type.
#[function]
pub fn to_wrapped(n: i8) -> u32 {
    let mut sum = 0;
    for i in 200..=n as u8 {
        sum += u32::from(i);
    }
    sum
}

#[function]
pub fn to_cut(n: u32) -> u32 {
    let mut sum = 0;
    for i in (200..=n as u8).rev() {
        sum += u32::from(i);
    }
    sum
}
