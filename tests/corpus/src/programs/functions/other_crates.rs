//! Types, components, traits, tables and functions of another crate that depends on `bessemer`: the C includes the
//! used items.

use bessemer::prelude::*;
use filters::quantities::Metres;
pub use filters::LowPass;
use filters::{Delay, Filter, Health, interpolate};

/// A reading to be filtered.
#[component]
#[derive(Clone, Debug, Default)]
pub struct Reading {
    low: LowPass,
    delay: Delay<f64, 3>,
    health: Health,
    height: Metres,
}

#[component]
impl Reading {
    /// Filters a reading.
    #[entry]
    pub fn step(&mut self, input: f64, valid: bool) -> f64 {
        self.health = match self.health {
            _ if valid => Health::Good,
            Health::Good => Health::Stale(1),
            Health::Stale(steps) => Health::Stale(steps.saturating_add(1)),
        };
        let smooth = self.low.step(interpolate(input));
        self.height = self.height + Metres(1.0);
        filters::larger(self.delay.push(smooth), self.height.number() * filters::LIMIT)
    }
}

/// A component that implements the other crate's trait.
#[component]
#[derive(Clone, Debug, Default)]
pub struct Gain {
    factor: f64,
}

#[component]
impl Filter for Gain {
    fn step(&mut self, input: f64) -> f64 {
        self.factor * input + filters::CURVE[2]
    }
}

/// Two filters in series.
#[component]
#[derive(Clone, Debug, Default)]
pub struct Both<A, B> {
    first: A,
    second: B,
}

#[component]
impl<A: Filter, B: Filter> Both<A, B> {
    /// Filters through both.
    #[entry]
    pub fn step(&mut self, input: f64) -> f64 {
        let between = self.first.step(input);
        self.second.step(between)
    }
}

/// A filter of the other crate, followed by the one above.
#[component]
pub type SmoothGain = Both<LowPass, Gain>;
