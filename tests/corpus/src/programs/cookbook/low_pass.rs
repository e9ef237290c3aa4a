//! A low-pass filter: Butterworth's of fourth order, designed on the target for any sample rate: the blocks `Section` and
//! `Cascade`.
//!
//! The coefficients come from the bilinear transform with prewarping, which keeps the cutoff exact. The filter is in
//! transposed direct form II, which has small rounding errors in `f32`.

use bessemer::prelude::*;
pub use bessemer_blocks::{Cascade, Section};

/// Quality of the sections, 1/(2 sin(π/8)) and 1/(2 sin(3π/8)) in reverse: the one with less resonance is first.
const QUALITIES: [f32; 2] = [0.541_196_1, 1.306_563];

/// Designs a Butterworth low-pass. The cutoff is limited to between a thousandth and 0.45 of the sample rate.
#[function]
pub fn butterworth(#[unit("Hz")] cutoff: f32, #[unit("Hz")] rate: f32) -> [Section<f32>; 2] {
    let limited = cutoff.max(0.001 * rate).min(0.45 * rate);
    QUALITIES.map(|quality| Section::low_pass(limited, quality, rate))
}

/// Filters a signal.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LowPass {
    cascade: Cascade<f32, 2>,
}

#[component]
impl LowPass {
    /// Filters one sample.
    #[entry(infallible)]
    pub fn step(&mut self, sections: &[Section<f32>; 2], sample: f32) -> f32 {
        self.cascade.step(sections, sample)
    }

    /// Sets the state as if the input had always been `sample`, so that switching on causes no transient.
    #[entry(infallible)]
    pub fn preset(&mut self, sections: &[Section<f32>; 2], sample: f32) {
        self.cascade.preset(sections, sample);
    }
}
