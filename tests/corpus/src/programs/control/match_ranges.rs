//! Long ranges and guards become `if` conditions, in order.

use bessemer::prelude::*;

/// Available power at a temperature, %.
#[function]
pub fn power(temperature: i16, boosted: bool) -> u8 {
    match temperature {
        i16::MIN..=-20 => 0,
        -19..=60 => 100,
        61..=80 if boosted => 90,
        61..=80 => 70,
        t if t < 100 => 20,
        _ => 0,
    }
}
