//! Patterns of closures: names that hide others, pairs with two names, nested ones, arguments that are parameters.

use bessemer::prelude::*;

/// The names of a pair differ from adapter to adapter.
#[function]
pub fn renamed(values: &[i32; 4], i: i32, x: i32) -> i32 {
    let found = values
        .iter()
        .enumerate()
        .filter(|(x, i)| *x > 0 && **i > 2)
        .filter(|&(i, &x)| i < 3 || x < 9)
        .map(|(i, x)| i as i32 * 3 + x % 11)
        .fold(x % 5, |i, x| i % 100 * 2 + x);
    found + i % 7 + x % 3
}

/// A pair next to an index, with each part bound separately.
#[function]
pub fn nested(a: &[i32; 4], b: &[i32; 4]) -> i32 {
    a.iter()
        .zip(b.iter())
        .enumerate()
        .filter(|(i, (x, y))| *i > 0 && x > y)
        .map(|(i, (x, y))| i as i32 ^ x ^ y)
        .fold(0, |sum, x| sum ^ x)
}

/// An array of pairs, by reference and by value.
#[function]
pub fn pairs(values: &[(i16, u8); 3]) -> (usize, i32, Option<i32>) {
    let below = values.iter().filter(|(a, b)| *a < i16::from(*b)).count();
    let sum =
        values.iter().filter(|&&(a, _)| a > 0).map(|&(a, b)| i32::from(a) + i32::from(b)).sum();
    let whole = values.iter().filter(|&(a, _)| *a != 3).map(|pair| i32::from(pair.0)).max();
    (below, sum, whole)
}

/// The parameters of one closure are the arguments of another.
#[function]
pub fn swapped(a: i32, b: i32) -> (i32, i32) {
    let turned = |(a, b): (i32, i32), _: i32| (b, a);
    let (c, d) = turned((b, a), a);
    turned((d, c), b)
}

/// Destructured temporaries; parts without a name are computed as well.
#[function]
pub fn made(values: &[u8; 4], divisor: u8) -> (u32, usize) {
    let sum = values
        .iter()
        .map(|x| (x / 2, x % 2))
        .filter(|(_, rest)| *rest == 0)
        .map(|(half, _)| u32::from(half))
        .sum();
    (sum, values.iter().map(|x| x / divisor).map(|_| 3).filter(|_| true).count())
}

/// A folded pair whose parts have the names of parameters.
#[function]
pub fn gathered(values: &[i32; 4], a: i32, b: i32) -> (i32, i32) {
    values.iter().fold((b % 100, a % 100), |(a, b), x| (b + x % 10, a + 1))
}

/// The chain ends at the first failure, and later items are not computed.
#[function]
pub fn tried(values: &[i8; 4], start: i8) -> (Option<i8>, u8) {
    let mut asked = 0;
    for value in values {
        if *value > 3 {
            asked += 1;
        }
    }
    let sum = values
        .iter()
        .map(|x| 10 / *x)
        .try_fold(start, |sum, x| if x == 5 { None } else { sum.checked_add(x) });
    (sum, asked)
}

/// Patterns in a condition that leads to another result.
#[function]
pub fn doubted(values: &[u8; 3], limit: u8) -> Result<u8, u8> {
    if values.iter().try_fold(0_u8, |sum, x| sum.checked_add(*x)).is_none() {
        return Err(1);
    }
    let sum = values.iter().try_fold(1_u8, |product, x| {
        if *x > limit { Err(*x) } else { Ok(product.wrapping_mul(*x)) }
    })?;
    Ok(sum)
}
