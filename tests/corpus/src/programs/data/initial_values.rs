//! A component starts with its `Default`, derived or written out; rustc evaluates it, and `_init` assigns it.

use bessemer::prelude::*;

/// A first-order low-pass.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Lowpass {
    /// Weight of a new value.
    pub share: f64,
    /// The smoothed value.
    pub value: f64,
    /// True after the first value.
    pub started: bool,
}

impl Default for Lowpass {
    fn default() -> Self {
        Lowpass { share: 1.0 / 8.0, value: 0.0, started: false }
    }
}

#[component]
impl Lowpass {
    /// Takes a value and returns the smoothed one.
    #[entry(infallible)]
    pub fn step(&mut self, value: f64) -> f64 {
        if !self.started {
            self.started = true;
            self.value = value;
        }
        self.value += self.share * (value - self.value);
        self.value
    }
}
