//! Arrays of structs.

use bessemer::prelude::*;

/// A value with its time.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    pub at: u32,
    pub value: f64,
    pub good: bool,
}

/// The type of this kind.
pub type It = [Sample; 3];
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut all = [Sample::default(); 3];
    all[1].value = x;
    all
}

/// A first value.
#[function]
pub fn one() -> It {
    [Sample { at: 1, value: -0.5, good: true }; 3]
}

/// A second, different value.
#[function]
pub fn other() -> It {
    let mut all = one();
    all[2].good = false;
    all
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[0].value = 8.0;
    it[1] = it[0];
}

include!("six.in");
include!("floats.in");
