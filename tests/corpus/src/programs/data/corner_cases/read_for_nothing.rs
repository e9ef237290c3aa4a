//! Reads without effect: a number that stays as it is, a default that is compared with itself.

use bessemer::prelude::*;

/// A number that is converted to a signed type and back in each iteration.
#[function]
pub fn stays(values: [u32; 3]) -> u32 {
    values.iter().skip(2).take(0).fold(8_u32, |sum, _| ((sum as i32) as u32))
}

/// A read without use before another statement.
#[function]
pub fn comes_back(values: [u32; 3], t: &mut u32) -> u32 {
    let mut kept = values[0];
    for value in values {
        *t = t.wrapping_add(value);
        kept = (kept as i32) as u32;
    }
    kept
}

/// A struct with a default.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Own {
    pub low: u8,
}

/// A default that is read only in a closure in which the comparison is known.
#[function]
#[allow(clippy::eq_op)]
pub fn compared(x: u8) -> bool {
    let own: Own = Own::default();
    let checked = if x > 3 { Ok::<u8, u16>(x) } else { Err(7) };
    checked.is_ok_and(|_| own != own)
}

/// A default that is never read.
#[function]
pub fn declared(x: f64) -> f64 {
    let _own: Own = Own::default();
    x
}
