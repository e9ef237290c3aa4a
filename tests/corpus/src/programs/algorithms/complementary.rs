//! A complementary filter for one angle: fast changes come from the gyroscope, slow ones from gravity.

use bessemer::prelude::*;

/// Estimate of the angle.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tilt {
    angle: f32,
}

#[component]
impl Tilt {
    /// Takes one sample: rate in rad/s, accelerations across and along gravity, and `time` in s since the last.
    #[entry(infallible)]
    pub fn step(&mut self, rate: f32, across: f32, along: f32, time: f32) -> f32 {
        let felt = across.atan2(along);
        let share = 0.5 / (0.5 + time);
        self.angle = share * (self.angle + rate * time) + (1.0 - share) * felt;
        self.angle
    }
}
