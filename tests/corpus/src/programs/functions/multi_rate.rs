//! Components in components, at different rates: the outer state
//! contains the inner states, and its `init` sets all of them.

use bessemer::prelude::*;

/// A first-order filter.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Smoother {
    level: f64,
}

#[component]
impl Smoother {
    fn step(&mut self, value: f64, share: f64) -> f64 {
        self.level += share * (value - self.level);
        self.level
    }
}

/// A rate loop at 200 Hz with an angle loop at 50 Hz around it.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TwoRates {
    fast: Smoother,
    slow: Smoother,
    wanted: f64,
    tick: u8,
}

#[component]
impl TwoRates {
    /// Number of fast periods in a slow one.
    const DIVIDER: u8 = 4;

    /// One period of 5 ms; returns the command.
    #[entry(infallible)]
    pub fn step(&mut self, target: f64, angle: f64, rate: f64) -> f64 {
        if self.tick == 0 {
            self.wanted = 4.0 * self.slow.step(target - angle, 0.5);
        }
        self.tick = self.tick.wrapping_add(1) % Self::DIVIDER;
        self.fast.step(self.wanted - rate, 0.8)
    }
}
