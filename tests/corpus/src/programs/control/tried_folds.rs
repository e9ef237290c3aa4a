//! `try_fold` accumulates until its closure fails.

use bessemer::prelude::*;

/// Reason why a text is not a number.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Trouble {
    /// The text contains a letter.
    #[default]
    Letter,
    /// The number does not fit its type.
    Beyond,
}

/// The sum, if it fits its type.
#[function]
pub fn total(values: &[u8; 5]) -> Option<u8> {
    values.iter().try_fold(0_u8, |sum, value| sum.checked_add(*value))
}

/// The number that digits write.
#[function]
pub fn number(digits: &[u8; 4]) -> Result<u16, Trouble> {
    digits.iter().try_fold(0, |value: u16, digit| {
        if !digit.is_ascii_digit() {
            return_letter()
        } else {
            value
                .checked_mul(10)
                .and_then(|tens| tens.checked_add(u16::from(digit - b'0')))
                .ok_or(Trouble::Beyond)
        }
    })
}

/// The error for a letter.
#[function]
pub fn return_letter() -> Result<u16, Trouble> {
    Err(Trouble::Letter)
}

/// The least and the greatest reading, if none is a NaN.
#[function]
pub fn span(readings: &[f32; 4]) -> Option<(f32, f32)> {
    readings.iter().try_fold((f32::INFINITY, f32::NEG_INFINITY), |(least, greatest), x| {
        if x.is_nan() { None } else { Some((least.min(*x), greatest.max(*x))) }
    })
}
