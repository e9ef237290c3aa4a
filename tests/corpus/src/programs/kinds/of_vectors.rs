//! Vectors.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = SVector<f64, 5>;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    SVector::<f64, 5>::repeat(x)
}

/// A first value.
#[function]
pub fn one() -> It {
    vector![1.0, 2.0, 3.0, 4.0, 5.0]
}

/// A second, different value.
#[function]
pub fn other() -> It {
    SVector::<f64, 5>::repeat(0.5)
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[4] = -1.0;
}

include!("six.in");
include!("floats.in");
