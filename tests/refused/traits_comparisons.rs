#![no_std]
extern crate std;

use bessemer::prelude::*;
use core::cmp::Ordering;

/// A level.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Level(pub f64);

#[data]
impl PartialEq for Level {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }

    fn ne(&self, other: &Self) -> bool {
        self.0 != other.0
    }
}

#[data]
impl PartialEq<f64> for Level {
    fn eq(&self, other: &f64) -> bool {
        self.0 == *other
    }
}

#[data]
impl PartialOrd for Level {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

fn main() {}
