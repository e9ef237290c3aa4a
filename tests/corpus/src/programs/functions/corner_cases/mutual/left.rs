//! Needs the other's `Middle`, which needs nothing.

use bessemer::prelude::*;

use super::right::{Far, Middle};

/// A number.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Near {
    /// Any.
    pub value: i16,
}

/// Type from the other module.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wide {
    /// Both ends.
    pub ends: [Middle; 2],
}

/// A sum that cannot overflow.
#[function]
pub fn weight(far: Far) -> i16 {
    let wide = Wide { ends: [Middle { share: far.share }; 2] };
    (wide.ends[0].share as i16).wrapping_add(far.near.value)
}
