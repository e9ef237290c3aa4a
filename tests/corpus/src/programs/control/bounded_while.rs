//! `#[bound]` declares the largest number of iterations of a `while` whose bound cannot be derived; one more is a
//! fault.

use bessemer::prelude::*;

/// The square root of a positive number (Newton's method), to within `tolerance`.
#[function]
pub fn root(x: f64, tolerance: f64) -> f64 {
    let mut guess = x.max(1.0);
    #[bound(40)]
    while guess * guess - x > tolerance {
        guess = (guess + x / guess) / 2.0;
    }
    guess
}
