#![no_std]
extern crate std;

use bessemer::prelude::*;
use core::ops::{Add, Deref};

/// A pair.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    /// One.
    pub a: f64,
}

#[data]
impl Deref for Pair {
    type Target = f64;
    fn deref(&self) -> &f64 {
        &self.a
    }
}

#[data]
impl Add<&mut Pair> for Pair {
    type Output = Pair;
    fn add(self, _other: &mut Pair) -> Pair {
        self
    }
}

#[data]
impl From<Pair> for [f64; 1] {
    fn from(pair: Pair) -> [f64; 1] {
        [pair.a]
    }
}

/// A type over any number.
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
