//! Operators and conversions of an author's own type that are not marked.
#![no_std]
use bessemer::prelude::*;
use core::ops::{Add, Mul, Neg};

/// A complex number.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Phasor {
    /// The real part.
    pub re: f64,
    /// The imaginary part.
    pub im: f64,
}

impl Add for Phasor {
    type Output = Phasor;
    fn add(self, other: Phasor) -> Phasor {
        Phasor { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Neg for Phasor {
    type Output = Phasor;
    fn neg(self) -> Phasor {
        Phasor { re: -self.re, im: -self.im }
    }
}

#[data]
impl Mul<f32> for Phasor {
    type Output = Phasor;
    fn mul(self, factor: f32) -> Phasor {
        Phasor { re: self.re * f64::from(factor), im: 0.0 }
    }
}

#[data]
impl Mul<f64> for Phasor {
    type Output = Phasor;
    fn mul(self, factor: f64) -> Phasor {
        Phasor { re: self.re * factor, im: 0.0 }
    }
}

/// The sum.
#[function]
pub fn sum(a: Phasor, b: Phasor) -> Phasor {
    a + b
}

/// The opposite.
#[function]
pub fn opposite(a: Phasor) -> Phasor {
    -a
}

/// A literal of two possible types: rustc's choice.
#[function]
pub fn twice(a: Phasor) -> Phasor {
    a * 2.0
}

/// A number with a weight.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Weighted<T> {
    /// The number.
    pub value: T,
}

#[data]
impl<T: Real> Add for Weighted<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Weighted { value: self.value + other.value }
    }
}

/// Sum of any type with an operator.
#[function]
pub fn added<V: Add<Output = V> + Copy>(a: V, b: V) -> V {
    a + b
}

/// Sum of a type whose operator is generic.
#[function]
pub fn of_weighted(a: Weighted<f32>) -> Weighted<f32> {
    added(a, a)
}
