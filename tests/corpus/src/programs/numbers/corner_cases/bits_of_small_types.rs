//! Bits that are shifted out of small types, and numbers combined from them.

use bessemer::prelude::*;

/// Bits that were shifted out are lost.
#[function]
pub fn out_and_back(x: u16, places: u8) -> u16 {
    let places = places % 16;
    ((x << places) >> 3) ^ ((x << places) >> places)
}

#[function]
pub fn put_together(x: u8, y: u8) -> u8 {
    (((x << 3) ^ y) | (y << 1)) >> 2
}

#[function]
pub fn made_smaller(x: u16, y: u8) -> u8 {
    (((x << 4) | ((y as u16) << 8)) >> 6) as u8
}

#[function]
pub fn picked(x: u16) -> bool {
    (x << 3) & 0x8000 != 0 || ((x << 5) ^ 0x00F0) & 0x0FF0 == 0
}
