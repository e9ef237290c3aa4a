//! A PI controller with limits, anti-windup and bumpless transfer: the block `Pid` without its derivative part.
//!
//! While the output is at a limit, the integral changes only in the direction away from it (conditional integration),
//! so it never winds up. No input is a fault; a measurement that is NaN gives the lower limit and leaves the integral
//! unchanged.

use bessemer::prelude::*;
pub use bessemer_blocks::{Pid, PidParameters};

/// Controls a speed.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PiController {
    pid: Pid<f32>,
}

#[component]
impl PiController {
    /// One control period; returns the voltage to apply.
    #[entry(infallible)]
    #[unit("V")]
    pub fn step(
        &mut self,
        parameters: &PidParameters<f32>,
        #[unit("rad/s")] target: f32,
        #[unit("rad/s")] measured: f32,
    ) -> f32 {
        self.pid.step(parameters, target, measured)
    }

    /// Takes over from manual control: the next step's output is `output` if target and measurement stay.
    #[entry(infallible)]
    pub fn preset(
        &mut self,
        parameters: &PidParameters<f32>,
        #[unit("rad/s")] target: f32,
        #[unit("rad/s")] measured: f32,
        #[unit("V")] output: f32,
    ) {
        self.pid.track(parameters, target, measured, output);
    }
}
