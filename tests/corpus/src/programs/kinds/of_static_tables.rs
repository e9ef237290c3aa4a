//! Statics: tables with an address.

use bessemer::prelude::*;

/// A gain, and the speed from which it applies.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gain {
    pub from: u16,
    pub share: f32,
}

/// The gains by speed.
#[data]
static GAINS: [Gain; 3] = [
    Gain { from: 0, share: 1.0 },
    Gain { from: 100, share: 0.5 },
    Gain { from: 200, share: 0.25 },
];

/// The type of this kind.
pub type It = [Gain; 3];
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut all = GAINS;
    all[1].share = x;
    all
}

/// A first value.
#[function]
pub fn one() -> It {
    GAINS
}

/// A second, different value.
#[function]
pub fn other() -> It {
    let mut all = GAINS;
    all[0].share = 0.0;
    all
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[2] = GAINS[0];
}

include!("six.in");
include!("floats.in");
