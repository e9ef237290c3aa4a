//! Arrays of options.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = [Option<i16>; 3];

/// A first value.
#[function]
pub fn one() -> It {
    [Some(1), None, Some(i16::MIN)]
}

/// A second, different value.
#[function]
pub fn other() -> It {
    [None; 3]
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[1] = Some(5);
    it[2] = None;
}

include!("six.in");
