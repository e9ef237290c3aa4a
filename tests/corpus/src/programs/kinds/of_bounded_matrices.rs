//! Matrices of up to so many rows and columns.

use bessemer::prelude::*;

/// The kind.
pub type It = BoundedMatrix<f64, 3, 2>;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    let mut made = BoundedMatrix::new(1, 1);
    made[(0, 0)] = x;
    made
}

/// One of them.
#[function]
pub fn one() -> It {
    let mut made = BoundedMatrix::new(2, 2);
    made[(0, 1)] = 1.5;
    made
}

/// Another.
#[function]
pub fn other() -> It {
    BoundedMatrix::new(3, 1)
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.resize(1, 2, -0.5);
}

include!("six.in");
include!("floats.in");
