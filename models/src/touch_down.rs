//! Touch-down detection of a landing aircraft.
//!
//! An aircraft has touched down when it is near the ground and no longer descends although commanded to. The height
//! alone would stop the motors in the air, and the aircraft would fall by the error of the height.

use crate::signals::{Estimate, Target};
use bessemer::prelude::*;

/// Height below which the ground can carry the aircraft, m.
#[requirement("HLR-15")]
#[data]
const CONTACT_HEIGHT: f64 = 0.1;

/// Vertical speed below which the aircraft is still, m/s: a fraction of any landing rate.
#[requirement("HLR-15")]
#[data]
const STILL_SPEED: f64 = 0.08;

/// Time for which the aircraft must be still, s.
#[requirement("HLR-15")]
#[data]
const CONFIRMATION_TIME: f64 = 0.15;

/// Depth below the ground that the target must reach first, m.
#[requirement("HLR-15")]
#[data]
const TARGET_DEPTH: f64 = 0.02;

/// Touch-down detector.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TouchDown {
    /// Time for which the aircraft has been still near the ground, s.
    pub still: f64,
    /// True after touch-down.
    pub landed: bool,
}

#[component]
impl TouchDown {
    /// Advances one period, s; returns true after touch-down. A bounce does not reset it; a new flight does.
    #[requirement("HLR-15")]
    #[entry(infallible)]
    pub fn step(&mut self, period: f64, target: &Target, estimate: &Estimate) -> bool {
        if !target.land {
            self.still = 0.0;
            self.landed = false;
            return false;
        }
        let near = estimate.position.z < CONTACT_HEIGHT && target.position.z < -TARGET_DEPTH;
        if near && estimate.velocity.z.abs() < STILL_SPEED {
            self.still += period;
        } else {
            self.still = 0.0;
        }
        self.landed = self.landed || self.still >= CONFIRMATION_TIME;
        self.landed
    }
}
