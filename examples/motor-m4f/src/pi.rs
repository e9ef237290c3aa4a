//! A PI controller.

use bessemer::prelude::*;

/// Gains of a loop.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gains {
    /// Gain of the error.
    pub proportional: f32,
    /// Gain of the error per period in the integral.
    pub integral: f32,
}

/// A PI controller with anti-windup.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pi {
    /// The integral part of the output.
    integral: f32,
}

#[component]
impl Pi {
    /// One period: the answer to an error, from −`limit` to `limit`. At the limit the integral stays.
    pub fn respond(&mut self, gains: &Gains, error: f32, limit: f32) -> f32 {
        let wanted = gains.proportional * error + self.integral;
        if wanted > limit {
            return limit;
        }
        if wanted < -limit {
            return -limit;
        }
        self.integral += gains.integral * error;
        wanted
    }
}
