//! Two rates in one component: a position loop around a speed loop that runs ten times as often.
//!
//! Firmware calls one entry point at the fast rate. The block `Rates` counts for the slow loop, so the loops are in step
//! in the simulation as on the target.

use bessemer::prelude::*;
pub use bessemer_blocks::{Pid, PidParameters, Rates, Schedule, Task};

/// Number of periods of the speed loop in one period of the position loop.
pub const SPEED_PERIODS: u32 = 10;

/// The position loop; the speed loop runs in each period.
const SCHEDULE: Schedule<1> =
    Schedule { tasks: [Task { period: SPEED_PERIODS, phase: 0, cost: 0 }] };

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
    pub speed: PidParameters<f32>,
}

/// Controls a position.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PositionServo {
    speed_loop: Pid<f32>,
    /// Speed setpoint from the position loop.
    #[unit("rad/s")]
    wanted_speed: f32,
    rates: Rates<1>,
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
        let [is_due] = self.rates.step(&SCHEDULE);
        if is_due {
            let limit = parameters.speed_limit;
            self.wanted_speed = (parameters.stiffness * (target - position)).max(-limit).min(limit);
        }
        self.speed_loop.step(&parameters.speed, self.wanted_speed, speed)
    }
}
