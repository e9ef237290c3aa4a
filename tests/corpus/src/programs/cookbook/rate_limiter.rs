//! A setpoint that changes no faster than its follower can: the block `RateLimiter`, which begins where that is.
//! Rise and fall have separate rates.

use bessemer::prelude::*;
pub use bessemer_blocks::{RateLimiter, RateLimits};

/// Moves a setpoint to its target.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Setpoint {
    limiter: RateLimiter<f32>,
    /// True after the first period in which the loop is closed.
    is_closed: bool,
}

#[component]
impl Setpoint {
    /// One control period; returns the setpoint. It reaches the target exactly; a target that is NaN leaves it
    /// unchanged. While the loop is open, the setpoint is the measurement.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        limits: &RateLimits<f32>,
        closed: bool,
        target: f32,
        measured: f32,
    ) -> f32 {
        let began = closed && !self.is_closed;
        self.is_closed = closed;
        if began {
            self.limiter.preset(measured);
        }
        if closed { self.limiter.step(limits, target) } else { measured }
    }
}
