//! A matrix with a name of its own.

use bessemer::prelude::*;

/// Covariance of an estimate.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Covariance(pub Matrix2<f64>);

/// The kind.
pub type It = Covariance;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    let mut made = other();
    made.0[(1, 0)] = x;
    made
}

/// One of them.
#[function]
pub fn one() -> It {
    Covariance(Matrix2::new(1.0, 2.0, 3.0, 4.0))
}

/// Another.
#[function]
pub fn other() -> It {
    Covariance(Matrix2::identity())
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.0[(0, 1)] = 7.0;
}

include!("six.in");
include!("floats.in");
