//! Types of one's own that are `Zero` and `One` of `num_traits`. Functions of these traits for numbers of known types.

use bessemer::prelude::*;
use core::ops::{Add, Mul};
use num_traits::{AsPrimitive, Float, FromPrimitive, One, ToPrimitive, Zero};

/// A number with one fractional part in a hundred.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cents(pub i64);

#[data]
impl Add for Cents {
    type Output = Cents;
    fn add(self, other: Cents) -> Cents {
        Cents(self.0.wrapping_add(other.0))
    }
}

#[data]
impl Mul for Cents {
    type Output = Cents;
    fn mul(self, other: Cents) -> Cents {
        Cents(self.0.wrapping_mul(other.0) / 100)
    }
}

#[data]
impl Zero for Cents {
    fn zero() -> Cents {
        Cents(0)
    }
    fn is_zero(&self) -> bool {
        self.0 == 0
    }
}

#[data]
impl One for Cents {
    fn one() -> Cents {
        Cents(100)
    }
}

/// The sum of products, from `zero`; `one` replaces zeros.
#[function]
fn dot<T: Zero + One + Copy>(one: [T; 3], other: [T; 3]) -> T {
    let mut total = T::zero();
    for k in 0..3 {
        let factor = if other[k].is_zero() { T::one() } else { other[k] };
        total = total + one[k] * factor;
    }
    total
}

#[function]
pub fn of_cents(one: [i64; 3], other: [i64; 3]) -> (i64, bool) {
    let sides = (one.map(Cents), other.map(Cents));
    let start = Cents::zero() + Cents::one();
    (dot(sides.0, sides.1).0, start.is_zero())
}

#[function]
pub fn of_numbers(x: [f64; 3], n: [f32; 3]) -> (f64, f32) {
    (dot(x, [0.0, 2.0, f64::one()]), dot(n, [f32::zero(), 0.5, 1.0]))
}

/// Conversions of numbers of known types.
#[function]
pub fn of_known(raw: u64, x: f64, n: i16) -> (u8, f32, i32, bool, Option<u8>, Option<i8>) {
    let low: u8 = raw.as_();
    let whole: i32 = x.as_();
    (low, n.as_(), whole, n.is_zero(), n.to_u8(), i8::from_f64(x))
}

/// The sign of a float of any width, also of zero and of NaN.
#[function]
fn signs<T: Float>(x: T) -> (bool, bool) {
    (x.is_sign_negative(), Float::is_sign_positive(x))
}

#[function]
pub fn of_signs(x: f64, y: f32) -> ((bool, bool), (bool, bool)) {
    (signs(x), signs(y))
}
