//! `==` and conversions of an author's own that are not marked, and one that comes back to itself.
#![no_std]
use bessemer::prelude::*;
use core::num::TryFromIntError;

/// An angle.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Bearing {
    /// From north, rad.
    pub radians: f64,
}

impl PartialEq for Bearing {
    fn eq(&self, other: &Bearing) -> bool {
        (self.radians - other.radians).abs() < 1.0e-3
    }
}

/// Position of the lever.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub enum Lever {
    /// Nothing.
    #[default]
    Parked,
    /// Nothing either.
    Neutral,
    /// The wheels.
    Forward,
}

impl PartialEq for Lever {
    fn eq(&self, other: &Lever) -> bool {
        matches!(self, Lever::Forward) == matches!(other, Lever::Forward)
    }
}

/// Error below the range.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Low(pub u8);

/// Error above the range.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct High(pub u16);

impl From<Low> for High {
    fn from(low: Low) -> High {
        High(u16::from(low.0))
    }
}

#[data]
impl From<TryFromIntError> for High {
    fn from(_error: TryFromIntError) -> High {
        High(0)
    }
}

/// A number that may not fit.
#[function]
pub fn fitting(x: i32) -> Result<u8, High> {
    let value = u8::try_from(x)?;
    Ok(value)
}

/// A count.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Count(pub u8);

#[data]
impl PartialEq for Count {
    fn eq(&self, other: &Count) -> bool {
        is_same(self, other)
    }
}

/// Compares by way of `==`.
#[function]
pub fn is_same(one: &Count, other: &Count) -> bool {
    one == other
}

/// Comparison of a struct.
#[function]
pub fn same_bearing(one: Bearing, other: Bearing) -> bool {
    one == other
}

/// Comparison of words.
#[function]
pub fn same_lever(one: Lever, other: Lever) -> bool {
    one != other
}

/// Comparison of elements.
#[function]
pub fn same_levers(one: [Lever; 3], other: [Lever; 3]) -> bool {
    one == other
}

/// Below.
#[function]
pub fn low(x: u8) -> Result<u8, Low> {
    if x > 9 { Err(Low(x)) } else { Ok(x) }
}

/// Above.
#[function]
pub fn high(x: u8) -> Result<u8, High> {
    let value = low(x)?;
    Ok(value)
}
