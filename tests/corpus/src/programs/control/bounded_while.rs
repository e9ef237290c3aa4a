//! `#[bound]` declares the number of passes of a `while` without a derivable bound; one more pass is a fault.

use bessemer::prelude::*;

/// The square root of a positive number (Newton), as near as `tolerance`.
#[function]
pub fn root(x: f64, tolerance: f64) -> f64 {
    let mut guess = x.max(1.0);
    #[bound(40)]
    while guess * guess - x > tolerance {
        guess = (guess + x / guess) / 2.0;
    }
    guess
}
