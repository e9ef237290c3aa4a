//! Ranges as values: a struct of their two ends.

pub use core::ops::{Range, RangeInclusive};

use bessemer::prelude::*;

/// Valid readings of a sensor.
pub const PLAUSIBLE: RangeInclusive<f32> = -40.0..=125.0;

/// A channel with limits.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Gauge {
    /// Accepted range.
    pub limits: RangeInclusive<f32>,
    /// Numbers of the samples of a period that count.
    pub samples: Range<u16>,
    /// The last accepted value.
    pub last: f32,
}

impl Default for Gauge {
    fn default() -> Self {
        Gauge { limits: PLAUSIBLE, samples: 2..14, last: 0.0 }
    }
}

#[component]
impl Gauge {
    /// Takes one sample of a period; returns its value if it is accepted.
    #[entry(infallible)]
    pub fn step(&mut self, number: u16, value: f32) -> Option<f32> {
        if !self.samples.contains(&number) || !self.limits.contains(&value) {
            return None;
        }
        self.last = value;
        Some((value - self.limits.start()) / (self.limits.end() - self.limits.start()))
    }

    /// Sets other limits; returns false if a range is empty.
    #[entry(infallible)]
    pub fn limit(&mut self, low: f32, high: f32, samples: Range<u16>) -> bool {
        let limits = RangeInclusive::new(low, high);
        if limits.is_empty() || samples.is_empty() || samples.end > 16 {
            return false;
        }
        self.limits = limits;
        self.samples = samples;
        true
    }
}

/// The middle of a range.
#[function]
pub fn middle(range: &RangeInclusive<i32>) -> i32 {
    range.start().midpoint(*range.end())
}
