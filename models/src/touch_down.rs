//! When a landing aircraft has touched down.
//!
//! It has when it is near the ground and no longer sinks although it is asked to: the height alone
//! would stop the motors in the air, and let the aircraft fall what the height is wrong by.

use crate::signals::{Estimate, Target};
use bessemer::prelude::*;

/// Height below which the ground can be what holds the aircraft, m.
#[data]
const NEAR: f64 = 0.1;

/// Speed below which it no longer sinks, m/s: a fraction of any rate of descent.
#[data]
const STILL: f64 = 0.08;

/// How long it has to stay still, s.
#[data]
const LONG_ENOUGH: f64 = 0.15;

/// Height below the ground that the target reaches before it is believed, m.
#[data]
const PUSHED: f64 = 0.02;

/// Tells touch-down from a slow descent.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TouchDown {
    /// How long the aircraft has been still near the ground, s.
    pub still: f64,
    /// Whether it has touched down.
    pub landed: bool,
}

#[component]
impl TouchDown {
    /// One period, s: whether the aircraft has landed. A bounce does not undo it, a new flight does.
    #[entry(infallible)]
    pub fn step(&mut self, period: f64, target: &Target, estimate: &Estimate) -> bool {
        if !target.land {
            self.still = 0.0;
            self.landed = false;
            return false;
        }
        let near = estimate.position.z < NEAR && target.position.z < -PUSHED;
        if near && estimate.velocity.z.abs() < STILL {
            self.still += period;
        } else {
            self.still = 0.0;
        }
        self.landed = self.landed || self.still >= LONG_ENOUGH;
        self.landed
    }
}
