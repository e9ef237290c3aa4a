//! `&` is a `const` pointer, `&mut` a pointer; scalars and results are values.

use bessemer::prelude::*;

/// Sums for a mean and a variance.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    pub count: u32,
    pub sum: f64,
    pub squares: f64,
}

/// Adds a value.
#[function]
pub fn take(moments: &mut Moments, value: f64) {
    moments.count = moments.count.wrapping_add(1);
    moments.sum += value;
    moments.squares += value * value;
}

/// The mean so far.
#[function]
pub fn mean(moments: &Moments) -> f64 {
    if moments.count == 0 { 0.0 } else { moments.sum / f64::from(moments.count) }
}

/// Adds two values; returns the mean.
#[function]
pub fn take_both(moments: &mut Moments, values: [f64; 2]) -> f64 {
    take(moments, values[0]);
    take(moments, values[1]);
    mean(moments)
}
