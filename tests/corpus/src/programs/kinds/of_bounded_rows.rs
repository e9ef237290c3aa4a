//! Matrices with a maximum number of rows, and a fixed number of columns.

use bessemer::prelude::*;

/// A matrix of zeros.
const RESTING: BoundedMatrix<f32, 4, 1> = BoundedMatrix::new(4, 1);

/// The type of this kind.
pub type It = BoundedMatrix<f32, 4, 1>;
/// The type of its numbers.
pub type Number = f32;

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
    let mut made = BoundedMatrix::new(2, 1);
    made[(1, 0)] = 1.5;
    made
}

/// A second, different value.
#[function]
pub fn other() -> It {
    RESTING
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.resize(3, 1, -0.5);
}

include!("six.in");
include!("floats.in");
