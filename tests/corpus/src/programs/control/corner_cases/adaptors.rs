//! Adapters in every order, on everything that has elements.

use bessemer::prelude::*;

#[function]
pub fn counted(values: &[i32; 7], skip: usize, take: usize) -> i32 {
    let mut sum = 0_i32;
    for (i, value) in values.iter().enumerate().skip(skip).take(take) {
        sum = sum.wrapping_mul(3).wrapping_add(value.wrapping_mul(i as i32));
    }
    for (i, value) in values.iter().skip(skip).take(take).enumerate() {
        sum = sum.wrapping_mul(5).wrapping_add(value.wrapping_mul(i as i32));
    }
    for (i, value) in values.iter().enumerate().rev() {
        sum = sum.wrapping_mul(7).wrapping_add(value.wrapping_mul(i as i32));
    }
    for (i, value) in values.iter().rev().enumerate() {
        sum = sum.wrapping_mul(9).wrapping_add(value.wrapping_mul(i as i32));
    }
    for value in values.iter().rev().skip(skip).take(2) {
        sum = sum.wrapping_mul(11).wrapping_add(*value);
    }
    for value in values.iter().take(take).rev() {
        sum = sum.wrapping_mul(13).wrapping_add(*value);
    }
    for (a, b) in values.iter().zip(values.iter().skip(1)) {
        sum = sum.wrapping_mul(15).wrapping_add(a.wrapping_sub(*b));
    }
    for (a, b) in values.iter().zip(&values[2..]).rev() {
        sum = sum.wrapping_mul(17).wrapping_add(a.wrapping_sub(*b));
    }
    for (a, b) in values.iter().zip(&values[2..]).skip(skip) {
        sum = sum.wrapping_mul(19).wrapping_add(a.wrapping_sub(*b));
    }
    sum
}

#[function]
pub fn windows(values: &List<i32, 6>, of: &[i32; 2]) -> i32 {
    let mut sum = 0_i32;
    for window in values.windows(3) {
        sum = sum.wrapping_mul(3).wrapping_add(window[0]).wrapping_sub(window[2]);
    }
    for chunk in values.chunks_exact(2) {
        sum = sum.wrapping_mul(5).wrapping_add(chunk[1]).wrapping_add(chunk.len() as i32);
    }
    for window in of.windows(3) {
        sum = sum.wrapping_add(window[0]);
    }
    for (i, window) in values.windows(2).enumerate() {
        sum = sum.wrapping_add(total(window).wrapping_mul(i as i32));
    }
    sum
}

#[function]
pub fn total(values: &[i32]) -> i32 {
    let mut total = 0_i32;
    for value in values.iter().rev() {
        total = total.wrapping_mul(2).wrapping_add(*value);
    }
    for (i, pair) in values.windows(2).enumerate() {
        total = total.wrapping_add(pair[0].wrapping_mul(pair[1])).wrapping_add(i as i32);
    }
    total
}

#[function]
pub fn extremes(values: &List<i16, 6>, most: usize) -> Option<i16> {
    let part = &values[..most];
    let largest = part.iter().max().copied()?;
    let least = *part.iter().min()?;
    let last = part.iter().copied().last().unwrap_or(0);
    Some(largest.wrapping_sub(least).wrapping_add(last))
}

#[function]
pub fn squares(limit: u32) -> Option<u32> {
    (1..20_u32).map(|n| n * n).filter(|square| square % 3 == 1).find(|square| *square > limit)
}

#[function]
pub fn farthest(values: &[i8; 4]) -> Option<i32> {
    values.iter().map(|value| (*value as i32).abs()).max()
}

#[function]
pub fn places(values: &[u8; 6], wanted: u8) -> usize {
    let first = values.iter().position(|value| *value == wanted);
    let behind = values.iter().skip(2).position(|value| *value == wanted).unwrap_or(9);
    let back = values.iter().rev().position(|value| *value == wanted).unwrap_or(8);
    match first {
        Some(first) => first * 100 + behind * 10 + back,
        None => 1000 + behind,
    }
}
