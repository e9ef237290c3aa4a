//! `from` converts only between types where no value is lost.

use bessemer::prelude::*;

/// A sum of readings of different widths.
#[function]
pub fn total(a: u8, b: i16, c: u32) -> i64 {
    i64::from(a) + i64::from(b) + i64::from(c)
}

/// A ratio in double precision.
#[function]
pub fn ratio(a: f32, b: u32) -> f64 {
    f64::from(a) / f64::from(b)
}
