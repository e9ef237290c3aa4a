//! A speed loop with a PID controller, in single precision, and a temperature loop in double precision that an
//! operator can take over.

use bessemer::prelude::*;
pub use bessemer_blocks::{Pid, PidParameters};

/// Holds a speed.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpeedLoop {
    pid: Pid<f32>,
}

#[component]
impl SpeedLoop {
    /// Advances one period; returns the voltage.
    #[entry(infallible, single)]
    pub fn step(&mut self, parameters: &PidParameters<f32>, target: f32, speed: f32) -> f32 {
        self.pid.step(parameters, target, speed)
    }
}

/// Holds a temperature, or follows an operator.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Oven {
    pid: Pid<f64>,
}

#[component]
impl Oven {
    /// Advances one period; returns the power. In manual mode it is `manual`.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        parameters: &PidParameters<f64>,
        target: f64,
        temperature: f64,
        manual: Option<f64>,
    ) -> f64 {
        match manual {
            Some(power) => {
                self.pid.track(parameters, target, temperature, power);
                power
            }
            None => self.pid.step(parameters, target, temperature),
        }
    }
}
