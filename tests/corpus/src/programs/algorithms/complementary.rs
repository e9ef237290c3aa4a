//! A complementary filter for one angle: the gyroscope for what is quick, gravity for what is slow.

use bessemer::prelude::*;

/// The angle.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tilt {
    angle: f32,
}

#[component]
impl Tilt {
    /// One sample: rate in rad/s, accelerations across and along gravity, `time` in s.
    #[entry(infallible)]
    pub fn step(&mut self, rate: f32, across: f32, along: f32, time: f32) -> f32 {
        let felt = across.atan2(along);
        let share = 0.5 / (0.5 + time);
        self.angle = share * (self.angle + rate * time) + (1.0 - share) * felt;
        self.angle
    }
}
