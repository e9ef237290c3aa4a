//! Complex numbers.

use bessemer::nalgebra::Complex;
use bessemer::prelude::*;

/// The type of this kind.
pub type It = Complex<f64>;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    Complex::new(x, 1.0)
}

/// A first value.
#[function]
pub fn one() -> It {
    Complex::new(1.0, -2.0)
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Complex::i()
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.im = it.re + 1.0;
}

include!("six.in");
include!("floats.in");
