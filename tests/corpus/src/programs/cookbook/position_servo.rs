//! Two rates in one component: a position loop around a speed loop that runs ten times as often.
//!
//! Firmware calls one entry point at the fast rate. The component has a counter for the slow loop, so the loops are
//! in step in the simulation as on the target.

use super::pi::{PiController, PiParameters};
use bessemer::prelude::*;

/// Number of periods of the speed loop in one period of the position loop.
pub const SPEED_PERIODS: u8 = 10;

/// Gains and limits of both loops.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ServoParameters {
    /// Speed setpoint for each rad of position error, 0 or more.
    #[unit("1/s")]
    pub stiffness: f32,
    /// Largest speed setpoint, 0 or more.
    #[unit("rad/s")]
    pub speed_limit: f32,
    /// Parameters of the speed loop.
    pub speed: PiParameters,
}

/// Controls a position.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PositionServo {
    speed_loop: PiController,
    /// Speed setpoint from the position loop.
    #[unit("rad/s")]
    wanted_speed: f32,
    /// Number of periods until the position loop is due.
    countdown: u8,
}

#[component]
impl PositionServo {
    /// One period of the speed loop; returns the voltage to apply.
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
