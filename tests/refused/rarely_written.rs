#![no_std]
extern crate std;

use bessemer::prelude::*;

macro_rules! nothing {
    () => {};
}

/// An implementation with more than methods.
#[data]
#[derive(Clone, Copy)]
pub struct Gains {
    /// Gain of the error.
    pub p: f64,
}

#[data]
impl Gains {
    nothing!();
}

/// A trait with more than methods.
#[interface]
pub trait Law {
    nothing!();
}

/// Rust's, by its name.
#[interface]
pub trait Add {
    /// The sum.
    fn sum(&self) -> f64;
}

#[data]
const _: f64 = 1.0;

/// The firmware's, of any type.
#[external(header = "board.h")]
pub fn read<T: Copy>(value: T) -> T {
    value
}

/// Assigned later.
#[function]
pub fn later(x: f64) -> f64 {
    let Gains { p };
    Gains { p } = Gains { p: x };
    p + x
}

/// One behind the other, of which one is turned round, beside a third.
#[function]
pub fn chained(values: [f64; 3], others: [f64; 3]) -> f64 {
    let mut sum = 0.0;
    for (value, other) in values.iter().chain(others.iter().rev()).zip(values.iter()) {
        sum += value * other;
    }
    sum
}

/// Kept in a tuple.
#[function]
pub fn kept(x: f64) -> f64 {
    let pair = (|value: f64| value * 2.0, x);
    pair.1
}

/// An iterator in a branch.
#[function]
pub fn branches(values: &[f64; 3]) -> impl Iterator<Item = f64> {
    return values.iter().copied();
}

/// Goes on later.
#[function]
pub fn later_on(x: f64) -> f64 {
    yield x;
    x
}

/// Nothing at all.
#[function]
pub fn nothing_at_all(x: f64) -> f64 {
    let y = _;
    x + y
}

/// Selects a variant.
#[function]
pub fn variant(one: Option<f64>, other: Option<f64>) -> bool {
    core::mem::discriminant(&one) == core::mem::discriminant(&other)
}

/// A closure by reference.
#[function]
pub fn lent(f: &impl Fn(f64) -> f64, x: f64) -> f64 {
    f(x)
}

/// A text that says what is wrong, without a condition.
#[function]
pub fn claimed(x: f64) -> f64 {
    assert!(x > 0.0 => "positive");
    x
}

fn main() {}
