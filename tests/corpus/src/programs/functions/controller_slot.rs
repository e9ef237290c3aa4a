//! An interface is a trait. A component with a slot for whatever implements it becomes C for each choice;
//! which function is called is decided when the C is written.

use bessemer::prelude::*;

/// Controllers that close a loop.
#[interface]
pub trait Controller {
    /// The largest command.
    const LIMIT: f64;

    /// One period: what to command.
    fn step(&mut self, error: f64) -> f64;

    /// Forgets what was.
    fn reset(&mut self) {}

    /// One step within the limits.
    fn limited(&mut self, error: f64) -> f64 {
        self.step(error).clamp(-Self::LIMIT, Self::LIMIT)
    }
}

/// A gain.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gain {
    /// By which an error is multiplied.
    pub gain: f64,
}

#[data]
impl Controller for Gain {
    const LIMIT: f64 = 1.0;

    fn step(&mut self, error: f64) -> f64 {
        self.gain * error
    }
}

/// An integrator.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Integrator {
    sum: f64,
}

#[component]
impl Controller for Integrator {
    const LIMIT: f64 = 0.5;

    fn step(&mut self, error: f64) -> f64 {
        self.sum += 0.01 * error;
        self.sum
    }

    fn reset(&mut self) {
        self.sum = 0.0;
    }
}

/// A loop around any controller.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Loop<C> {
    /// The controller.
    pub controller: C,
}

#[component]
impl<C: Controller> Loop<C> {
    /// One period.
    #[entry(infallible)]
    pub fn step(&mut self, target: f64, measured: f64, reset: bool) -> f64 {
        if reset {
            self.controller.reset();
        }
        self.controller.limited(target - measured)
    }
}

/// A loop that a gain closes.
#[component]
pub type GainLoop = Loop<Gain>;

/// A loop that an integrator closes.
#[component]
pub type IntegratorLoop = Loop<Integrator>;
