//! A finite impulse response filter over a ring of samples.

use bessemer::prelude::*;

/// Number of taps of the filter.
const TAPS: usize = 8;
/// A low-pass; symmetric, so its phase is linear.
const COEFFICIENTS: [f64; TAPS] = [0.01, 0.08, 0.17, 0.24, 0.24, 0.17, 0.08, 0.01];

/// The last samples, in a ring buffer.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fir {
    samples: [f64; TAPS],
    newest: usize,
}

#[component]
impl Fir {
    /// Filters one sample.
    #[entry]
    pub fn step(&mut self, sample: f64) -> f64 {
        self.newest = (self.newest + 1) % TAPS;
        self.samples[self.newest] = sample;
        let mut sum = 0.0;
        for (i, coefficient) in COEFFICIENTS.iter().enumerate() {
            sum += coefficient * self.samples[(self.newest + TAPS - i) % TAPS];
        }
        sum
    }
}
