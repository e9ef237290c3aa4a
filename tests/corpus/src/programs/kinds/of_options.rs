//! Options of a float.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = Option<f64>;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    Some(x)
}

/// A first value.
#[function]
pub fn one() -> It {
    Some(-0.5)
}

/// A second, different value.
#[function]
pub fn other() -> It {
    None
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = if it.is_some() { None } else { Some(4.0) };
}

include!("six.in");
include!("floats.in");
