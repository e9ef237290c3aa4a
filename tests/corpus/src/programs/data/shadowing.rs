//! A name may be declared again; the C numbers the later variables if both are in scope.

use bessemer::prelude::*;

/// A raw count as a temperature, °C.
#[function]
pub fn temperature(raw: u16) -> f32 {
    let raw = raw & 0x0fff;
    let volts = raw as f32 * (3.3 / 4096.0);
    let volts = volts - 0.5;
    volts / 0.01
}
