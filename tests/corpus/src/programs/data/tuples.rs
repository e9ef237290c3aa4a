//! A tuple is a struct named for what it is made of; a function gives several results as one.

use bessemer::prelude::*;

/// Whole turns, and the angle that is left, rad.
#[function]
pub fn unwound(angle: f64) -> (i32, f64) {
    let turns = (angle / 6.25).floor();
    (turns as i32, angle - turns * 6.25)
}

/// The angle that is left of two after another, rad.
#[function]
pub fn together(one: f64, other: f64) -> f64 {
    let (_, first) = unwound(one);
    let second = unwound(other);
    first + second.1
}
