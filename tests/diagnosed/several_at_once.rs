//! A case.
#![no_std]
use bessemer::prelude::*;

/// A sum of what is no number.
#[function]
pub fn first(list: &[Option<f64>; 3]) -> Option<f64> {
    list.iter().copied().sum()
}

/// A mutable reference that an `if` chooses.
#[function]
pub fn second(left: &mut f64, right: &mut f64, first: bool) {
    let chosen = if first { left } else { right };
    *chosen += 1.0;
}
