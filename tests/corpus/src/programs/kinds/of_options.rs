//! Options of a word.

use bessemer::prelude::*;

/// The kind.
pub type It = Option<f64>;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    Some(x)
}

/// One of them.
#[function]
pub fn one() -> It {
    Some(-0.5)
}

/// Another.
#[function]
pub fn other() -> It {
    None
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = if it.is_some() { None } else { Some(4.0) };
}

include!("six.in");
include!("floats.in");
