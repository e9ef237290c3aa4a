//! A rate limiter: a set point that moves no faster than what follows it can, up and down at rates of their own.

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

/// Follows a set point at limited rates.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RateLimiter {
    /// Last output.
    output: f32,
}

#[component]
impl RateLimiter {
    /// One control period: the limited set point. It arrives exactly; a target that is NaN leaves it where it is.
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

    /// Begins at a value, such as what is measured when the loop is closed.
    #[entry(infallible)]
    pub fn preset(&mut self, output: f32) {
        self.output = output;
    }
}
