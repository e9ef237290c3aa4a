//! Fields packed into a word and extracted from it.

use bessemer::prelude::*;

/// A time of day in FAT's format: hours, minutes, pairs of seconds.
#[function]
pub fn packed(hours: u8, minutes: u8, seconds: u8) -> u16 {
    (u16::from(hours) & 31) << 11 | (u16::from(minutes) & 63) << 5 | (u16::from(seconds) / 2 & 31)
}

/// The hours of a time in this format.
#[function]
pub fn hours(time: u16) -> u8 {
    (time >> 11) as u8
}
