//! Matrices with a maximum number of rows and columns.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = BoundedMatrix<f64, 3, 2>;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut made = BoundedMatrix::new(1, 1);
    made[(0, 0)] = x;
    made
}

/// A first value.
#[function]
pub fn one() -> It {
    let mut made = BoundedMatrix::new(2, 2);
    made[(0, 1)] = 1.5;
    made
}

/// A second, different value.
#[function]
pub fn other() -> It {
    BoundedMatrix::new(3, 1)
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.resize(1, 2, -0.5);
}

include!("six.in");
include!("floats.in");
