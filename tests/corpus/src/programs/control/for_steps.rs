//! `step_by` takes every n-th number of a range.

use bessemer::prelude::*;

/// The sum of the even elements, and of the odd ones in reverse order, halved at each step.
#[function]
pub fn interleaved(values: &[f64; 10]) -> f64 {
    let mut sum = 0.0;
    for i in (0..10).step_by(2) {
        sum += values[i];
    }
    for i in (1..10).step_by(2).rev() {
        sum = 0.5 * sum + values[i];
    }
    sum
}

/// Every third number from `from` to below `to`.
#[function]
pub fn thirds(from: u8, to: u8) -> u32 {
    let mut sum = 0;
    for n in (from..to).step_by(3) {
        sum += n as u32;
    }
    sum
}

/// The sum of every `step`-th element. A step of 0 is a fault, as Rust's is a panic.
#[function]
pub fn every(values: &[f64; 10], count: usize, step: usize) -> f64 {
    let mut sum = 0.0;
    for i in (0..count.min(10)).step_by(step) {
        sum += values[i];
    }
    sum
}

/// A range of signed numbers with any ends and step, upwards with its end and downwards without.
#[function]
pub fn signed(low: i8, high: i8, step: usize) -> i32 {
    let mut sum = 0;
    for x in (low..=high).step_by(step) {
        sum = sum / 2 + i32::from(x);
    }
    for x in (low..high).step_by(3).rev() {
        sum = sum / 2 - i32::from(x);
    }
    sum
}

/// A range whose end is the largest number of the type.
#[function]
pub fn late(from: u64, step: usize) -> u64 {
    let mut last = 0;
    for n in (from..=from.saturating_add(9)).step_by(step) {
        last = n;
    }
    for n in (from..from.saturating_add(9)).step_by(step) {
        last ^= n;
    }
    last
}

/// Negative numbers, in a constant range and a variable one, and in a chain.
#[function]
pub fn negative(from: i32, width: u8) -> i32 {
    let from = from.clamp(-1000, 1000);
    let mut sum = 0;
    for x in (-9..10).step_by(4) {
        sum += x;
    }
    sum + (from..from + i32::from(width)).step_by(5).map(|x| x % 7).sum::<i32>()
}

/// The ends are evaluated before the step, which changes one of them.
#[function]
pub fn moved(start: u8) -> u32 {
    let mut end = 20_u8;
    let mut sum = 0;
    for n in (start..end).step_by({
        end = 3;
        usize::from(end)
    }) {
        sum += u32::from(n);
    }
    sum + u32::from(end)
}

/// Signed 64-bit numbers whose distance exceeds the type. Returns the last number and the number of iterations.
#[function]
pub fn farthest(from: i64, to: i64, step: usize) -> (i64, u32) {
    let mut passes = 0_u32;
    let mut last = 0;
    for n in (from..=to).step_by(step) {
        last = n;
        passes += 1;
        if passes == 50 {
            break;
        }
    }
    for n in (from..to).step_by(step) {
        last ^= n;
        passes += 1;
        if passes >= 100 {
            break;
        }
    }
    (last, passes)
}

/// A range over a whole type; the loop ends after a few iterations.
#[function]
pub fn all(start: u64) -> u64 {
    let mut sum = 0_u64;
    for n in (start..=u64::MAX).step_by(1) {
        sum = sum.wrapping_add(n);
        if n % 16 == 7 {
            break;
        }
    }
    sum
}
