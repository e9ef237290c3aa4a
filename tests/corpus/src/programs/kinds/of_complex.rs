//! Complex numbers.

use bessemer::nalgebra::Complex;
use bessemer::prelude::*;

/// The kind.
pub type It = Complex<f64>;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    Complex::new(x, 1.0)
}

/// One of them.
#[function]
pub fn one() -> It {
    Complex::new(1.0, -2.0)
}

/// Another.
#[function]
pub fn other() -> It {
    Complex::i()
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.im = it.re + 1.0;
}

include!("six.in");
include!("floats.in");
