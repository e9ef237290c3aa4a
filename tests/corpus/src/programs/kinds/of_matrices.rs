//! Matrices.

use bessemer::prelude::*;

/// The kind.
pub type It = SMatrix<f32, 2, 3>;
/// Its numbers.
pub type Number = f32;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    let mut made = other();
    made[(0, 2)] = x;
    made
}

/// One of them.
#[function]
pub fn one() -> It {
    SMatrix::<f32, 2, 3>::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
}

/// Another.
#[function]
pub fn other() -> It {
    SMatrix::<f32, 2, 3>::zeros()
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it[(1, 2)] = -1.0;
}

include!("six.in");
include!("floats.in");
