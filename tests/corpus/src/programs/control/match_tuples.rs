//! `match` on several values at once.

use bessemer::prelude::*;

/// The drive of a wheel from two switches.
#[function]
pub fn drive(forward: bool, backward: bool, speed: i16) -> i16 {
    match (forward, backward) {
        (true, false) => speed,
        (false, true) => speed.wrapping_neg(),
        (true, true) | (false, false) => 0,
    }
}
