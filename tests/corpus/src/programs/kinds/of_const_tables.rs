//! Constant arrays: tables for reading.

use bessemer::prelude::*;

/// Two rows of levels.
const LEVELS: [[i16; 3]; 2] = [[-300, 0, 300], [1, 2, 3]];
/// Two rows of steps, including the limits of the type.
#[data]
const STEPS: [[i16; 3]; 2] = [[i16::MIN, -1, i16::MAX], [7, 8, 9]];

/// The type of this kind.
pub type It = [[i16; 3]; 2];

/// A first value.
#[function]
pub fn one() -> It {
    STEPS
}

/// A second, different value.
#[function]
pub fn other() -> It {
    LEVELS
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[1] = STEPS[0];
}

include!("six.in");
