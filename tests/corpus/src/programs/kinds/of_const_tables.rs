//! Constants of arrays: tables that are read.

use bessemer::prelude::*;

/// Levels.
const LEVELS: [[i16; 3]; 2] = [[-300, 0, 300], [1, 2, 3]];
/// Steps between them.
#[data]
const STEPS: [[i16; 3]; 2] = [[i16::MIN, -1, i16::MAX], [7, 8, 9]];

/// The kind.
pub type It = [[i16; 3]; 2];

/// One of them.
#[function]
pub fn one() -> It {
    STEPS
}

/// Another.
#[function]
pub fn other() -> It {
    LEVELS
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it[1] = STEPS[0];
}

include!("six.in");
