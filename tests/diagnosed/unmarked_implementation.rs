use bessemer::prelude::*;

/// Controllers that close a loop.
#[interface]
pub trait Controller {
    /// One period.
    fn step(&mut self, error: f64) -> f64;
}

/// A gain.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gain {
    /// By which an error is multiplied.
    pub gain: f64,
}

impl Controller for Gain {
    fn step(&mut self, error: f64) -> f64 {
        self.gain * error
    }
}

#[function]
fn closed<C: Controller>(controller: &mut C, error: f64) -> f64 {
    controller.step(error)
}

/// A loop.
#[function]
pub fn with_gain(gain: &mut Gain, error: f64) -> f64 {
    closed(gain, error)
}
