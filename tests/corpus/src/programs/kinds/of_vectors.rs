//! Vectors.

use bessemer::prelude::*;

/// The kind.
pub type It = SVector<f64, 5>;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    SVector::<f64, 5>::repeat(x)
}

/// One of them.
#[function]
pub fn one() -> It {
    vector![1.0, 2.0, 3.0, 4.0, 5.0]
}

/// Another.
#[function]
pub fn other() -> It {
    SVector::<f64, 5>::repeat(0.5)
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it[4] = -1.0;
}

include!("six.in");
include!("floats.in");
