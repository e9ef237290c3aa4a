//! Ranges whose numbers are passed to a closure by reference first.

use bessemer::prelude::*;

#[function]
pub fn odd(limit: i32) -> i32 {
    let limit = limit.clamp(0, 20);
    let count = (0..limit).filter(|i| i % 2 == 1).count() as i32;
    let sum: i32 = (0..limit).filter(|i| i % 2 == 1).sum();
    let squares: i32 = (0..limit).filter(|&i| i % 3 == 1).map(|i| i * i).sum();
    let product: i64 = (1..=5_i64).filter(|i| *i != 3).product();
    count + 100 * sum + squares - product as i32
}

#[function]
pub fn stepped(limit: u32) -> u32 {
    let limit = limit.min(30);
    let least = (0..limit).filter(|i| i % 4 == 3).map(|i| 50 - i).min().unwrap_or(7);
    let back = (0..limit).rev().filter(|i| i % 5 == 2).fold(0, |sum: u32, i| (3 * sum + i) % 1000);
    let even: u32 = (0..limit).step_by(2).filter(|i| i % 3 == 0).sum();
    let largest = (0..limit).filter(|i| *i < 9).max().unwrap_or(1);
    let last = (0..=29_u32).step_by(3).filter(|i| i & 1 == 0).last().unwrap_or(2);
    least + 2 * back + 3 * even + 5 * largest + 7 * last
}

#[function]
pub fn looped(values: &[i16; 8], from: usize) -> i32 {
    let mut sum = 0;
    for i in (0..8_usize).filter(|i| *i >= from) {
        sum = 2 * sum + i32::from(values[i]);
    }
    for i in (0..8).rev().filter(|i| i % 2 == 0).filter(|&i| i != 4) {
        sum -= i32::from(values[i]);
    }
    sum
}

#[function]
pub fn found(limit: u16) -> Option<u16> {
    let first = (1..100_u16).find(|n| n * n > limit)?;
    let other = (1..100).filter(|n| n % 7 == 0).find(|&n| n > first)?;
    Some(first + 1000 * u16::from((first..other).filter(|n| n % 2 == 0).any(|n| n == 6)))
}
