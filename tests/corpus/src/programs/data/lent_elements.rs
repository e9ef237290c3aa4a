//! `get_mut`, `first_mut`, `last_mut`, `split_first`, `split_last`, `split_at` and their `_mut` return
//! references to elements: in the C these are the array itself. Their results are destructured at the call.

use bessemer::prelude::*;

/// Adds to a counter; returns false if there is none with this number.
#[function]
pub fn count(counters: &mut [u32; 6], number: usize, by: u32) -> bool {
    let Some(counter) = counters.get_mut(number) else { return false };
    *counter = counter.saturating_add(by);
    true
}

/// Halves the first and the last element.
#[function]
fn halve_ends(values: &mut [f32]) {
    if let Some(first) = values.first_mut() {
        *first /= 2.0;
    }
    if let Some(last) = values.last_mut() {
        *last /= 2.0;
    }
}

/// The values with the ends of the part before `end` halved.
#[function]
pub fn tapered(mut values: [f32; 5], end: usize) -> [f32; 5] {
    halve_ends(&mut values[..end]);
    values
}

/// The sum of the later values minus the sum of the earlier ones; a fault if `middle` exceeds the length.
#[function]
pub fn balance(values: &[i16; 8], middle: usize) -> i32 {
    let (earlier, later) = values.split_at(middle);
    let mut balance = 0;
    for value in later {
        balance += i32::from(*value);
    }
    for value in earlier {
        balance -= i32::from(*value);
    }
    balance
}

/// Copies the first half onto the second, doubled.
#[function]
pub fn mirror(values: &mut [u8; 8]) {
    let (front, back) = values.split_at_mut(4);
    for (to, from) in back.iter_mut().zip(front.iter()) {
        *to = from.wrapping_mul(2);
    }
}

/// Amount by which the mean of the other values exceeds the first.
#[function]
fn above(values: &[f64]) -> f64 {
    match values.split_first() {
        Some((first, rest)) => {
            let mut sum = 0.0;
            for value in rest {
                sum += value - first;
            }
            sum
        }
        None => 0.0,
    }
}

/// That amount for the values from `start` on, without the last.
#[function]
pub fn above_from(values: &[f64; 6], start: usize) -> f64 {
    let Some((_, values)) = values.split_last() else { return 0.0 };
    above(&values[start..])
}
