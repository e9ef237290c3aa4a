//! Two rates in one component: a position loop around a speed loop that runs ten times as often.
//!
//! Firmware calls one entry point at the fast rate. The slow loop is due at a counter that the component keeps, so that
//! both loops are in step in the simulation as on the target.

use super::pi::{PiController, PiParameters};
use bessemer::prelude::*;

/// Periods of the speed loop for each of the position loop.
pub const SPEED_PERIODS: u8 = 10;

/// Gains and limits of both loops.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ServoParameters {
    /// Speed for each rad of position error, 0 or more.
    #[unit("1/s")]
    pub stiffness: f32,
    /// Highest speed that the position loop asks for, 0 or more.
    #[unit("rad/s")]
    pub speed_limit: f32,
    /// The speed loop.
    pub speed: PiParameters,
}

/// Holds a position.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PositionServo {
    speed_loop: PiController,
    /// Speed setpoint from the position loop.
    #[unit("rad/s")]
    wanted_speed: f32,
    /// Periods until the position loop is due.
    countdown: u8,
}

#[component]
impl PositionServo {
    /// One period of the speed loop: the voltage to apply.
    #[entry(infallible)]
    #[unit("V")]
    pub fn step(
        &mut self,
        parameters: &ServoParameters,
        #[unit("rad")] target: f32,
        #[unit("rad")] position: f32,
        #[unit("rad/s")] speed: f32,
    ) -> f32 {
        if self.countdown == 0 {
            self.countdown = SPEED_PERIODS;
            let limit = parameters.speed_limit;
            self.wanted_speed = (parameters.stiffness * (target - position)).max(-limit).min(limit);
        }
        self.countdown = self.countdown.saturating_sub(1);
        self.speed_loop.step(&parameters.speed, self.wanted_speed, speed)
    }
}
