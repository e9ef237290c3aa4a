//! `try_from` converts an integer if it fits; `try_into` converts to the expected type.

use bessemer::prelude::*;

/// A level limited to the range of a byte.
#[function]
pub fn level(x: i32) -> u8 {
    u8::try_from(x).unwrap_or(if x < 0 { 0 } else { u8::MAX })
}

/// A number of steps; `None` if it exceeds what a motor can take at once.
#[function]
pub fn steps(x: i64) -> Option<i16> {
    i16::try_from(x).ok()
}

/// An index from a frame; `None` if it is negative or beyond the table.
#[function]
pub fn index(x: i8) -> Option<usize> {
    let Ok(index) = usize::try_from(x) else { return None };
    if index < 12 { Some(index) } else { None }
}

/// Returns true if a count fits into its field.
#[function]
pub fn fits(count: u32) -> bool {
    let narrow: Result<u8, _> = count.try_into();
    narrow.is_ok()
}

/// The signed difference of two unsigned counts; a fault on overflow.
#[function]
pub fn difference(now: u32, before: u32) -> i32 {
    let (now, before) = (i64::from(now), i64::from(before));
    (now - before).try_into().unwrap()
}
