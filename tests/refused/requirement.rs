#![no_std]
extern crate std;

use bessemer::prelude::*;

/// No identifier.
#[requirement]
#[function]
pub fn none(x: f64) -> f64 {
    x
}

/// A number for an identifier.
#[requirement(12)]
#[function]
pub fn number(x: f64) -> f64 {
    x
}

/// Two identifiers, which are taken.
#[requirement("HLR-1", "HLR-2")]
#[function]
pub fn both(x: f64) -> f64 {
    x
}

fn main() {}
