//! The C comment of a computed constant shows the author's
//! expression; a plain value has no such comment.

use bessemer::prelude::*;

/// The length of a day, s.
#[data]
const DAY: u32 = 24 * 3600;

#[data]
const SIXTH: f64 = -1.0 / 6.0;

/// A mask computed from another constant.
#[data]
const LEFT: u32 = 1 << 24 | (DAY & 0xFF);

/// Contribution of each of the three motors.
#[data]
const SHARES: [f64; 3] = [0.25 * -SIXTH; 3];

/// The largest step.
#[data]
const LARGEST: i16 = i16::MAX;

/// Proportional and derivative gain.
#[data]
const GAINS: Gains = Gains::damped(2.0, -0.5);

/// Gains of a controller.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gains {
    pub proportional: f64,
    pub derivative: f64,
}

impl Gains {
    const fn damped(proportional: f64, ratio: f64) -> Gains {
        Gains { proportional, derivative: proportional * ratio }
    }
}

/// Uses all constants.
#[function]
pub fn mixed(x: f64, step: i16) -> f64 {
    let time = (DAY ^ LEFT) as f64;
    let bounded = if step == LARGEST { SIXTH } else { SHARES[1] };
    GAINS.proportional * x + GAINS.derivative * time + bounded
}

/// Initial gains of a controller.
#[function]
pub fn gains() -> Gains {
    GAINS
}
