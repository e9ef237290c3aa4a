//! A biquad filter: a second-order Butterworth low-pass, designed on the target for any sample rate.
//!
//! The coefficients come from the bilinear transform with prewarping, which keeps the cutoff exact. The filter is in
//! transposed direct form II, which has small rounding errors in `f32`. Filters of higher order are several of them
//! in series.

use bessemer::prelude::*;

/// Coefficients of `(b0 + b1/z + b2/z²) / (1 + a1/z + a2/z²)`.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BiquadCoefficients {
    /// Coefficients of the input: b0, b1, b2.
    pub b: [f32; 3],
    /// Coefficients of the output: a1, a2.
    pub a: [f32; 2],
}

/// Designs a second-order Butterworth low-pass. The cutoff is limited to between a thousandth and 0.45 of the sample
/// rate.
#[function]
pub fn butterworth(#[unit("Hz")] cutoff: f32, #[unit("Hz")] rate: f32) -> BiquadCoefficients {
    let share = (cutoff / rate).max(0.001).min(0.45);
    let warped = (f32::PI * share).tan();
    let damping = core::f32::consts::SQRT_2 * warped;
    let square = warped * warped;
    let scale = 1.0 / (1.0 + damping + square);
    let b0 = square * scale;
    BiquadCoefficients {
        b: [b0, 2.0 * b0, b0],
        a: [2.0 * (square - 1.0) * scale, (1.0 - damping + square) * scale],
    }
}

/// State of a second-order filter.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BiquadFilter {
    memory: [f32; 2],
}

#[component]
impl BiquadFilter {
    /// Filters one sample.
    #[entry(infallible)]
    pub fn step(&mut self, coefficients: &BiquadCoefficients, sample: f32) -> f32 {
        let [b0, b1, b2] = coefficients.b;
        let [a1, a2] = coefficients.a;
        let output = b0 * sample + self.memory[0];
        self.memory[0] = b1 * sample - a1 * output + self.memory[1];
        self.memory[1] = b2 * sample - a2 * output;
        output
    }

    /// Sets the state as if the input had always been `sample`, so that switching on causes no transient.
    #[entry(infallible)]
    pub fn preset(&mut self, coefficients: &BiquadCoefficients, sample: f32) {
        let [_, b1, b2] = coefficients.b;
        let [a1, a2] = coefficients.a;
        self.memory[1] = (b2 - a2) * sample;
        self.memory[0] = (b1 - a1) * sample + self.memory[1];
    }
}
