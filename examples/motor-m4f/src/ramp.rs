//! A rate limiter.

use bessemer::prelude::*;

/// Follows a set point at a limited rate.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ramp {
    /// The output of the last period.
    output: f32,
}

#[component]
impl Ramp {
    /// One period: the target, or what lies `most` nearer to it.
    pub fn follow(&mut self, target: f32, most: f32) -> f32 {
        let change = target - self.output;
        if change > most {
            self.output += most;
        } else if change < -most {
            self.output -= most;
        } else {
            self.output = target;
        }
        self.output
    }
}
