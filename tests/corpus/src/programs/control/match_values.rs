//! `match` on integers, with several values, ranges and a default: the cases of a `switch`.

use bessemer::prelude::*;

/// The kind of a character.
#[function]
pub fn kind(c: u8) -> u8 {
    match c {
        b'0'..=b'9' => 1,
        b'+' | b'-' => 2,
        b' ' | 9 | 10 | 13 => 3,
        _ => 0,
    }
}
