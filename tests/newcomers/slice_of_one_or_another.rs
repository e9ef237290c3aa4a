//! The louder of two channels, as a slice.
use bessemer::prelude::*;

#[function]
pub fn louder<'a>(left: &'a [f64], right: &'a [f64]) -> &'a [f64] {
    if left[0] > right[0] { left } else { right }
}
