//! Variables that a loop or a closure binds with `mut` are copies: changing them changes neither element nor counter.

use bessemer::prelude::*;

/// Elements that pass a filter and are then changed as copies.
#[function]
pub fn raised(values: &mut [i32; 4]) -> i32 {
    let raised = values.iter().copied().filter(|x| *x > 0).map(|mut x| {
        x = x.wrapping_add(1);
        x
    }).fold(0, |sum, x| sum ^ x);
    values[0] ^= 1;
    raised
}

/// Changed copies in the first closure of a chain, in a later one, and in an index.
#[function]
pub fn raised_each(values: &[i16; 3]) -> i64 {
    let plain = values.iter().copied().map(|mut x| {
        x = x.wrapping_mul(3);
        i64::from(x)
    }).sum::<i64>();
    let second = values.iter().map(|x| i64::from(*x)).filter(|x| *x > 1).map(|mut x| {
        x += 1;
        x
    }).sum::<i64>();
    let index = values.iter().enumerate().map(|(mut i, x)| {
        i += usize::from(*x > 0);
        i
    }).sum::<usize>();
    plain + second + index as i64
}

/// Changed copies of loop counters.
#[function]
pub fn counted(last: u8) -> u32 {
    let mut sum = 0;
    for mut i in 0..last % 7 {
        i |= 4;
        sum += u32::from(i);
    }
    for i in (1..last % 5).filter_map(|mut n| { n *= 2; (n > 3).then_some(n) }) {
        sum += 100 * u32::from(i);
    }
    for (mut i, n) in [3_u8, 1, last].iter().enumerate() {
        i += 2;
        sum ^= i as u32 * u32::from(*n);
    }
    sum
}
