//! The tangent: the quotient of sine and cosine of the reduced angle.

use super::sine::{cosine_of_rest, reduced_angle, sine_of_rest};
use crate::prelude::*;

/// Tangent of an angle in rad.
#[function]
pub fn tan(x: f64) -> f64 {
    let angle = reduced_angle(x);
    let sine = sine_of_rest(angle.rest);
    let cosine = cosine_of_rest(angle.rest);
    if angle.quadrant == 0.0 || angle.quadrant == 2.0 { sine / cosine } else { -cosine / sine }
}
