//! An interface is a trait. A component with a type parameter for an implementation becomes C for each choice; calls
//! are resolved when the C is generated.

use bessemer::prelude::*;

/// Controllers for a loop.
#[interface]
pub trait Controller {
    /// The largest command.
    const LIMIT: f64;

    /// One period; returns the command.
    fn step(&mut self, error: f64) -> f64;

    /// Resets the state.
    fn reset(&mut self) {}

    /// One period, with the command limited.
    fn limited(&mut self, error: f64) -> f64 {
        self.step(error).clamp(-Self::LIMIT, Self::LIMIT)
    }
}

/// A proportional controller.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gain {
    /// Factor of the error.
    pub gain: f64,
}

#[data]
impl Controller for Gain {
    const LIMIT: f64 = 1.0;

    fn step(&mut self, error: f64) -> f64 {
        self.gain * error
    }
}

/// An integrating controller.
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

/// A loop with any controller.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Loop<C> {
    /// The controller.
    pub controller: C,
}

#[component]
impl<C: Controller> Loop<C> {
    /// One period; returns the command.
    #[entry(infallible)]
    pub fn step(&mut self, target: f64, measured: f64, reset: bool) -> f64 {
        if reset {
            self.controller.reset();
        }
        self.controller.limited(target - measured)
    }
}

/// A loop with a proportional controller.
#[component]
pub type GainLoop = Loop<Gain>;

/// A loop with an integrating controller.
#[component]
pub type IntegratorLoop = Loop<Integrator>;
