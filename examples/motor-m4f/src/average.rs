//! A moving average.

use bessemer::prelude::*;

/// Samples of the average.
pub const SAMPLES: usize = 8;

/// The mean of the last samples.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Average {
    /// The samples, of which the oldest is replaced next.
    samples: [f32; SAMPLES],
    /// Index of the oldest value, which is replaced next.
    next: u32,
}

#[component]
impl Average {
    /// One period: takes a sample.
    pub fn take(&mut self, sample: f32) -> f32 {
        let next = self.next % SAMPLES as u32;
        self.samples[next as usize] = sample;
        self.next = (next + 1) % SAMPLES as u32;
        let mut sum = 0.0;
        for sample in &self.samples {
            sum += sample;
        }
        sum / SAMPLES as f32
    }
}
