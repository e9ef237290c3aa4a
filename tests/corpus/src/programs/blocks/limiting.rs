//! A valve whose set point is limited, and a heater with hysteresis.

use bessemer::prelude::*;
pub use bessemer_blocks::{
    Hysteresis, JerkLimiter, JerkLimits, Motion, RateLimiter, RateLimits, Saturated, dead_band,
    saturated,
};

/// Moves a valve.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Valve {
    rate: RateLimiter<f32>,
    closing: Hysteresis,
}

#[component]
impl Valve {
    /// Advances one period; returns the position, limited to 0 … 1.
    #[entry(infallible, single)]
    pub fn step(&mut self, limits: &RateLimits<f32>, stick: f32, pressure: f32) -> Saturated<f32> {
        let wanted = dead_band(stick, 0.05);
        let wanted = if self.closing.step(8.0, 6.0, pressure) { 0.0 } else { wanted };
        saturated(self.rate.step(limits, wanted), 0.0, 1.0)
    }

    /// Continues from the measured position.
    #[entry(infallible, single)]
    pub fn preset(&mut self, position: f32) {
        self.rate.preset(position);
    }
}

/// Moves a camera's gimbal smoothly.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gimbal {
    limiter: JerkLimiter<f64>,
    away: Hysteresis,
}

#[component]
impl Gimbal {
    /// Advances one period; returns the angle and its rate.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        limits: &JerkLimits<f64>,
        #[unit("rad")] target: f64,
        lost: bool,
    ) -> Motion<f64> {
        if lost {
            self.limiter.preset(0.0);
        }
        let target = if self.away.step(3.0, 2.5, target) { 3.0 } else { target };
        self.limiter.step(limits, target)
    }
}
