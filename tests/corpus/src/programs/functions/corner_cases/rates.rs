//! Components made of components that run at different rates.

use bessemer::prelude::*;

/// A first-order filter.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LowPass {
    /// The filtered signal.
    pub level: f64,
}

#[component]
impl LowPass {
    /// Weight of a new sample.
    const SHARE: f64 = 0.25;

    /// A filter that starts at a level.
    fn at(level: f64) -> Self {
        Self { level }
    }

    fn step(&mut self, signal: f64) -> f64 {
        self.level += Self::SHARE * (signal - self.level);
        self.level
    }
}

/// Filters three channels at every call, and their sum at every fourth.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rates {
    /// The fast filters, one for each channel.
    pub channels: [LowPass; 3],
    /// The slow filter.
    pub slow: LowPass,
    /// Number of calls since the slow filter ran.
    pub tick: u8,
}

#[component]
impl Rates {
    /// Number of calls in one period of the slow filter.
    const DIVIDER: u8 = 4;

    /// One fast period.
    #[entry]
    pub fn run(&mut self, x: f64, y: f64, reset: bool) -> f64 {
        let signals = [x, y, x - y];
        let mut sum = 0.0;
        for (channel, signal) in self.channels.iter_mut().zip(signals) {
            sum += channel.step(signal);
        }
        if reset {
            self.channels[1] = LowPass::at(y);
        }
        self.tick += 1;
        if self.tick == Self::DIVIDER {
            self.tick = 0;
            self.slow.step(sum);
        }
        self.slow.level
    }
}
