//! The tangent: the quotient of sine and cosine of the reduced angle, both in two doubles.

use super::pair::quotient;
use super::sine::{cosine_of_rest, reduced_angle, sine_of_rest};
use crate::prelude::*;

/// Tangent of an angle in rad.
#[function]
pub fn tan(x: f64) -> f64 {
    // 2⁻²⁷: below, an angle is its own tangent.
    if x.abs() < 7.450580596923828e-9 {
        return x;
    }
    let angle = reduced_angle(x);
    let sine = sine_of_rest(angle.high, angle.low);
    let cosine = cosine_of_rest(angle.high, angle.low);
    if (angle.quadrant & 1) == 0 {
        quotient(sine, cosine).high
    } else {
        -quotient(cosine, sine).high
    }
}
