//! A tuple becomes a struct whose name lists its types; a function returns several results as one.

use bessemer::prelude::*;

/// Whole turns, and the remaining angle, rad.
#[function]
pub fn unwound(angle: f64) -> (i32, f64) {
    let turns = (angle / 6.25).floor();
    (turns as i32, angle - turns * 6.25)
}

/// The remaining angle of a sum of two, rad.
#[function]
pub fn together(one: f64, other: f64) -> f64 {
    let (_, first) = unwound(one);
    let second = unwound(other);
    first + second.1
}
