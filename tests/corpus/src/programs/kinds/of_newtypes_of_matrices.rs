//! A newtype of a matrix.

use bessemer::prelude::*;

/// Covariance of an estimate.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Covariance(pub Matrix2<f64>);

/// The type of this kind.
pub type It = Covariance;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut made = other();
    made.0[(1, 0)] = x;
    made
}

/// A first value.
#[function]
pub fn one() -> It {
    Covariance(Matrix2::new(1.0, 2.0, 3.0, 4.0))
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Covariance(Matrix2::identity())
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.0[(0, 1)] = 7.0;
}

include!("six.in");
include!("floats.in");
