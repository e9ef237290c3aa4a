//! `match` on a `bool`.

use bessemer::prelude::*;

/// The level of a pin that may be inverted.
#[function]
pub fn level(high: bool, inverted: bool) -> u8 {
    match high ^ inverted {
        true => 1,
        false => 0,
    }
}
