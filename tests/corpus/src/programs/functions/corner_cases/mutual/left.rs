//! Uses `Middle` of the module `right`, which itself needs no other type.

use bessemer::prelude::*;

use super::right::{Far, Middle};

/// A struct with one number.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Near {
    /// An arbitrary number.
    pub value: i16,
}

/// A struct with a type of the other module.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wide {
    /// Two structs of the other module.
    pub ends: [Middle; 2],
}

/// A sum that cannot overflow.
#[function]
pub fn weight(far: Far) -> i16 {
    let wide = Wide { ends: [Middle { share: far.share }; 2] };
    (wide.ends[0].share as i16).wrapping_add(far.near.value)
}
