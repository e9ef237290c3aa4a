//! The arctangent of two coordinates.
//!
//! The ratio of the smaller to the larger coordinate, 0 to 1, is brought within 1/8 of a multiple of
//! a quarter by atan t = atan c + atan((t − c) / (1 + t·c)); then Gregory's series, whose truncation
//! stays under 0.01 ulp.

use core::f64::consts::{FRAC_PI_2, PI};

use crate::prelude::*;

/// π/2 less its nearest double.
const FRAC_PI_2_LOW: f64 = 6.123_233_995_736_766e-17;
/// π less its nearest double.
const PI_LOW: f64 = 1.224_646_799_147_353_2e-16;

/// atan(1/4), atan(1/2), atan(3/4), atan(1).
const CENTRE_ANGLES: [f64; 4] = [
    0.244_978_663_126_864_15,
    0.463_647_609_000_806_1,
    0.643_501_108_793_284_4,
    core::f64::consts::FRAC_PI_4,
];

/// Arctangent of −1/8 to 1/8, rad.
#[function]
pub fn arctangent_near_zero(t: f64) -> f64 {
    const A3: f64 = -1.0 / 3.0;
    const A5: f64 = 1.0 / 5.0;
    const A7: f64 = -1.0 / 7.0;
    const A9: f64 = 1.0 / 9.0;
    const A11: f64 = -1.0 / 11.0;
    const A13: f64 = 1.0 / 13.0;
    const A15: f64 = -1.0 / 15.0;
    const A17: f64 = 1.0 / 17.0;
    let z = t * t;
    let high = A11 + z * (A13 + z * (A15 + z * A17));
    let tail = A3 + z * (A5 + z * (A7 + z * (A9 + z * high)));
    t + t * z * tail
}

/// Arctangent of `t` by way of a centre `c` whose arctangent is `angle`, rad.
#[function]
pub fn arctangent_near(t: f64, c: f64, angle: f64) -> f64 {
    angle + arctangent_near_zero((t - c) / (1.0 + t * c))
}

/// Arctangent of 0 to 1, rad.
#[function]
pub fn arctangent_of_ratio(t: f64) -> f64 {
    if t <= 0.125 {
        arctangent_near_zero(t)
    } else if t <= 0.375 {
        arctangent_near(t, 0.25, CENTRE_ANGLES[0])
    } else if t <= 0.625 {
        arctangent_near(t, 0.5, CENTRE_ANGLES[1])
    } else if t <= 0.875 {
        arctangent_near(t, 0.75, CENTRE_ANGLES[2])
    } else {
        arctangent_near(t, 1.0, CENTRE_ANGLES[3])
    }
}

/// The angle of the point (`x`, `y`) in rad, −π to π; special values as C99 Annex F has them.
#[function]
pub fn atan2(y: f64, x: f64) -> f64 {
    let width = x.abs();
    let height = y.abs();
    let ratio = if width == height {
        // Both zero, both infinite, or on a diagonal.
        if width == 0.0 { 0.0 } else { 1.0 }
    } else if height < width {
        height / width
    } else {
        width / height
    };
    let from_axis = arctangent_of_ratio(ratio);
    let left = 1.0_f64.copysign(x) < 0.0;
    let angle = if height > width {
        let from_vertical = if left { from_axis } else { -from_axis };
        (FRAC_PI_2 + from_vertical) + FRAC_PI_2_LOW
    } else if left {
        (PI - from_axis) + PI_LOW
    } else {
        from_axis
    };
    angle.copysign(y)
}
