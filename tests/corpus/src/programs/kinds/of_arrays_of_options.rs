//! Arrays of options.

use bessemer::prelude::*;

/// The kind.
pub type It = [Option<i16>; 3];

/// One of them.
#[function]
pub fn one() -> It {
    [Some(1), None, Some(i16::MIN)]
}

/// Another.
#[function]
pub fn other() -> It {
    [None; 3]
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it[1] = Some(5);
    it[2] = None;
}

include!("six.in");
