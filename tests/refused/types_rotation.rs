#![no_std]
extern crate std;

use bessemer::nalgebra::UnitComplex;
use bessemer::prelude::*;

/// Not one of those that there are.
#[function]
pub fn plane(turn: UnitComplex<f64>) -> f64 {
    turn.re
}

fn main() {}
