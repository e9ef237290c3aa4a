//! A `loop` may end in its middle or at its end, and a `while` when a list becomes empty.

use bessemer::prelude::*;

/// Number of digits of a number.
#[function]
pub fn digits(n: u32) -> u32 {
    let (mut rest, mut count) = (n, 0);
    loop {
        count += 1;
        rest /= 10;
        if rest == 0 {
            break;
        }
    }
    count
}

/// The least power of two that is not below `n`.
#[function]
pub fn power_above(n: u32) -> u32 {
    let mut power = 1;
    while power < n {
        power *= 2;
    }
    power
}

/// The elements in reverse order.
#[function]
pub fn turned(values: &List<u8, 5>) -> List<u8, 5> {
    let (mut left, mut turned) = (*values, List::new());
    while let Some(value) = left.pop() {
        turned.push(value);
    }
    turned
}

/// Length without trailing zeros.
#[function]
pub fn trimmed(values: &List<u8, 5>) -> usize {
    let mut left = *values;
    while !left.is_empty() {
        if left[left.len() - 1] != 0 {
            return left.len();
        }
        left.pop();
    }
    0
}
