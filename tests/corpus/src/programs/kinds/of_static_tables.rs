//! Statics: a table that has a place.

use bessemer::prelude::*;

/// A gain from a speed on.
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

/// The kind.
pub type It = [Gain; 3];
/// Its numbers.
pub type Number = f32;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    let mut all = GAINS;
    all[1].share = x;
    all
}

/// One of them.
#[function]
pub fn one() -> It {
    GAINS
}

/// Another.
#[function]
pub fn other() -> It {
    let mut all = GAINS;
    all[0].share = 0.0;
    all
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it[2] = GAINS[0];
}

include!("six.in");
include!("floats.in");
