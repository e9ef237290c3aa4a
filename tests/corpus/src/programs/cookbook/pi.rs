//! A PI controller with limits, anti-windup and bumpless transfer.
//!
//! While the output is at a limit, the integral changes only in the direction away from it (conditional integration),
//! so it never winds up. No input is a fault; a measurement that is NaN gives the lower limit and leaves the integral
//! unchanged.

use bessemer::prelude::*;

/// Gains and limits of a speed loop.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PiParameters {
    /// Proportional gain, 0 or more.
    #[unit("V·s/rad")]
    pub proportional: f32,
    /// Integral gain, 0 or more.
    #[unit("V/rad")]
    pub integral: f32,
    /// Control period, above 0.
    #[unit("s")]
    pub period: f32,
    /// Lowest output.
    #[unit("V")]
    pub low: f32,
    /// Highest output, not below the lowest.
    #[unit("V")]
    pub high: f32,
}

/// Controls a speed.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PiController {
    /// Integral part of the output.
    #[unit("V")]
    integral: f32,
}

#[component]
impl PiController {
    /// One control period; returns the voltage to apply.
    #[entry(infallible)]
    #[unit("V")]
    pub fn step(
        &mut self,
        parameters: &PiParameters,
        #[unit("rad/s")] target: f32,
        #[unit("rad/s")] measured: f32,
    ) -> f32 {
        let error = target - measured;
        let integral = self.integral + parameters.integral * parameters.period * error;
        let wanted = parameters.proportional * error + integral;
        let output = wanted.max(parameters.low).min(parameters.high);
        // Positive above the upper limit, negative below the lower one.
        let beyond = wanted - output;
        if beyond * error <= 0.0 {
            self.integral = integral;
        }
        output
    }

    /// Takes over from manual control: the next step's output is `output` if the error is 0.
    #[entry(infallible)]
    pub fn preset(&mut self, parameters: &PiParameters, #[unit("V")] output: f32) {
        self.integral = output.max(parameters.low).min(parameters.high);
    }
}
