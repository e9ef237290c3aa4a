//! A rate limiter: a setpoint that changes no faster than its follower can, with separate rates for rise and fall.

use bessemer::prelude::*;

/// Largest rates of a setpoint.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlewLimits {
    /// Fastest rise, 0 or more.
    #[unit("1/s")]
    pub rise: f32,
    /// Fastest fall, 0 or more.
    #[unit("1/s")]
    pub fall: f32,
    /// Control period, above 0.
    #[unit("s")]
    pub period: f32,
}

/// Follows a setpoint at limited rates.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RateLimiter {
    /// Last output.
    output: f32,
}

#[component]
impl RateLimiter {
    /// One control period; returns the limited setpoint. It reaches the target exactly; a target that is NaN leaves
    /// it unchanged.
    #[entry(infallible)]
    pub fn step(&mut self, limits: &SlewLimits, target: f32) -> f32 {
        let highest = self.output + limits.rise * limits.period;
        let lowest = self.output - limits.fall * limits.period;
        if target > highest {
            self.output = highest;
        } else if target < lowest {
            self.output = lowest;
        } else if target.is_finite() {
            self.output = target;
        }
        self.output
    }

    /// Starts at a value, such as the measurement when the loop is closed.
    #[entry(infallible)]
    pub fn preset(&mut self, output: f32) {
        self.output = output;
    }
}
