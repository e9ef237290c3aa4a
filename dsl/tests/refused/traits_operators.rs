#![no_std]
extern crate std;

use bessemer::prelude::*;
use core::ops::{Add, Mul, Rem};

/// A pair.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    /// One.
    pub a: f64,
}

#[data]
impl Rem for Pair {
    type Output = Pair;
    fn rem(self, _other: Pair) -> Pair {
        self
    }
}

#[data]
impl Add<&Pair> for Pair {
    type Output = Pair;
    fn add(self, _other: &Pair) -> Pair {
        self
    }
}

#[data]
impl Mul<Pair> for f64 {
    type Output = Pair;
    fn mul(self, other: Pair) -> Pair {
        other
    }
}

/// Of any number.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Wide<T> {
    /// One.
    pub a: T,
}

#[data]
impl<T: Real> PartialEq for Wide<T> {
    fn eq(&self, other: &Wide<T>) -> bool {
        self.a == other.a
    }
}

fn main() {}
