//! Matrices.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = SMatrix<f32, 2, 3>;
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut made = other();
    made[(0, 2)] = x;
    made
}

/// A first value.
#[function]
pub fn one() -> It {
    SMatrix::<f32, 2, 3>::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
}

/// A second, different value.
#[function]
pub fn other() -> It {
    SMatrix::<f32, 2, 3>::zeros()
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[(1, 2)] = -1.0;
}

include!("six.in");
include!("floats.in");
