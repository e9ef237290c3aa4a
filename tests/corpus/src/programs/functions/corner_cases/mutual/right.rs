//! Needs the other's `Near`, which needs nothing.

use bessemer::prelude::*;

use super::left::Near;

/// A share.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Middle {
    /// Fraction, of 256.
    pub share: u8,
}

/// Type from the other module.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Far {
    /// The number.
    pub near: Near,
    /// Fraction, of 256.
    pub share: u8,
}

/// With the share of a number.
#[function]
pub fn far_of(near: Near, share: i16) -> Far {
    Far { near, share: share as u8 }
}
