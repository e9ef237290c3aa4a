//! Iterators as parameters: the function's loop iterates over the argument, with the values that were copied into it.

#![allow(missing_docs)]

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NumberSet {
    pub bits: u32,
}

#[data]
impl NumberSet {
    pub fn single(n: usize) -> NumberSet {
        NumberSet { bits: 1 << (n % 32) }
    }

    pub fn iter(self) -> impl Iterator<Item = u32> {
        (0..32).filter(move |&n| self.bits >> n & 1 == 1)
    }
}

#[data]
impl FromIterator<usize> for NumberSet {
    fn from_iter<I: IntoIterator<Item = usize>>(iter: I) -> Self {
        iter.into_iter()
            .fold(NumberSet::default(), |set, n| NumberSet { bits: set.bits | NumberSet::single(n).bits })
    }
}

#[function]
fn total(values: impl IntoIterator<Item = u32>) -> u32 {
    values.into_iter().fold(1, |sum, value| u32::wrapping_add(sum, value))
}

#[function]
fn mean<'a, I>(values: I) -> f64
where
    I: IntoIterator<Item = &'a f64>,
    I::IntoIter: ExactSizeIterator,
{
    let (mut sum, mut n) = (0.0, 0_u32);
    for value in values {
        sum += value;
        n += 1;
    }
    sum / f64::from(n)
}

/// A `return` inside the loop leaves this function, and not its caller.
#[function]
fn first_above<T: Real>(values: impl Iterator<Item = T>, limit: T) -> Option<T> {
    for value in values {
        if value > limit {
            return Some(value);
        }
    }
    None
}

#[function]
fn checked(values: impl IntoIterator<Item = Option<u32>>) -> Option<u32> {
    let mut sum = 0_u32;
    for value in values {
        sum = sum.checked_add(value?)?;
    }
    Some(sum)
}

#[function]
fn by_place(values: impl Iterator<Item = (usize, u32)>) -> u64 {
    values.map(|(at, value)| at as u64 * u64::from(value)).sum()
}

/// Passes its parameter on.
#[function]
fn twice(values: impl Iterator<Item = u32>) -> u32 {
    total(values.map(|value| value.wrapping_mul(2)))
}

#[function]
fn through_both(values: impl Iterator<Item = u32>) -> u32 {
    twice(values)
}

/// Writes to a variable that its iterator was made from.
#[function]
fn counting(values: impl IntoIterator<Item = u32>, count: &mut u32) -> u32 {
    *count = 5;
    let mut sum = 0_u32;
    for value in values {
        *count += 1;
        sum ^= value.wrapping_mul(*count);
    }
    sum
}

#[function]
fn cleared(values: &mut [u32; 4], of: impl Iterator<Item = u32>) -> u32 {
    values.fill(0);
    total(of)
}

#[function]
fn doubled<'a>(values: impl IntoIterator<Item = &'a mut u32>) {
    for value in values {
        *value = value.wrapping_mul(2);
    }
}

#[function]
pub fn totals(xs: [u32; 4], n: u32, count: usize) -> [u32; 8] {
    let inputs = NumberSet { bits: n };
    [
        total(0..n % 8),
        total((1..=n % 8).rev()),
        total(xs),
        total(xs.iter().copied()),
        total(xs[..count % 5].iter().map(|x| x & 15).filter(|x| x % 2 == 0)),
        total(inputs.iter()),
        twice(xs.into_iter()),
        through_both(xs.iter().skip(1).copied()),
    ]
}

#[function]
pub fn means(xs: [f64; 5], count: usize, limit: f64) -> (f64, f64, Option<f64>, f64) {
    let above = first_above(xs.iter().map(|x| x * 0.5), limit);
    let next = match first_above(xs.into_iter(), limit) {
        Some(x) if x > 1.0 => x,
        Some(_) => return (0.0, 1.0, above, 2.0),
        None => limit,
    };
    (mean(&xs), mean(xs[..count % 6].iter()), above, next)
}

#[function]
pub fn sums(xs: [u32; 3], ys: [Option<u32>; 3]) -> (Option<u32>, Option<u32>, u64) {
    (checked(ys), checked(xs.iter().map(|&x| x.checked_mul(3))), by_place(xs.into_iter().enumerate()))
}

/// Copies that an iterator makes when it is constructed.
#[function]
pub fn copied_before(mut n: u32, mut xs: [u32; 4]) -> (u32, u32, u32, u32, [u32; 4]) {
    n %= 8;
    let mut first = xs[0];
    let kept = counting(0..n, &mut n);
    let whole = counting(xs, &mut xs[1]);
    let set = NumberSet { bits: first };
    let own = counting(set.iter(), &mut first);
    let all = cleared(&mut xs, [n, first].into_iter());
    doubled(&mut xs[1..]);
    doubled(xs.iter_mut());
    (kept, whole, own, all, xs)
}

#[function]
pub fn gathered(xs: [u32; 6], n: usize) -> [NumberSet; 4] {
    let small: NumberSet = (0..n % 9).collect();
    [
        xs.iter().enumerate().filter(|(_, x)| **x > 3).map(|(at, _)| at).collect(),
        NumberSet::from_iter([1, 2, n]),
        small,
        NumberSet { bits: xs[0] }.iter().map(|bit| bit as usize + 1).collect::<NumberSet>(),
    ]
}
