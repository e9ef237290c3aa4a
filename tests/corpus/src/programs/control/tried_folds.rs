//! `try_fold` gathers as long as its closure gives something to go on with.

use bessemer::prelude::*;

/// Why a text is no number.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Trouble {
    /// A letter.
    #[default]
    Letter,
    /// More than fits.
    Beyond,
}

/// The sum, if it fits.
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

/// No number.
#[function]
pub fn return_letter() -> Result<u16, Trouble> {
    Err(Trouble::Letter)
}

/// The least and the greatest reading, if all are numbers.
#[function]
pub fn span(readings: &[f32; 4]) -> Option<(f32, f32)> {
    readings.iter().try_fold((f32::INFINITY, f32::NEG_INFINITY), |(least, greatest), x| {
        if x.is_nan() { None } else { Some((least.min(*x), greatest.max(*x))) }
    })
}
