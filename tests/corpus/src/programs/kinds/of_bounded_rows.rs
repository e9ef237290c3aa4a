//! Matrices of up to so many rows, and a fixed number of columns.

use bessemer::prelude::*;

/// Zeros.
const RESTING: BoundedMatrix<f32, 4, 1> = BoundedMatrix::new(4, 1);

/// The kind.
pub type It = BoundedMatrix<f32, 4, 1>;
/// Its numbers.
pub type Number = f32;

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
    let mut made = BoundedMatrix::new(2, 1);
    made[(1, 0)] = 1.5;
    made
}

/// Another.
#[function]
pub fn other() -> It {
    RESTING
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.resize(3, 1, -0.5);
}

include!("six.in");
include!("floats.in");
