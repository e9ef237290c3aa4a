//! Uses `Near` of the module `left`, which itself needs no other type.

use bessemer::prelude::*;

use super::left::Near;

/// A fraction.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Middle {
    /// The fraction times 256.
    pub share: u8,
}

/// A struct with a type of the other module.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Far {
    /// A struct of the other module.
    pub near: Near,
    /// A fraction times 256.
    pub share: u8,
}

/// Combines a number and a fraction.
#[function]
pub fn far_of(near: Near, share: i16) -> Far {
    Far { near, share: share as u8 }
}
