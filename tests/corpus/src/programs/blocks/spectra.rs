//! Spectrum of a vibration: an FFT, and the power of one tone.

use bessemer::prelude::*;
pub use bessemer_blocks::{fft, goertzel, roots_f32, roots_f64};

/// Roots of unity for 16 points.
#[data]
pub static ROOTS: [[f32; 2]; 8] = roots_f32();
/// Roots of unity for 8 points in double precision.
#[data]
pub static FINE_ROOTS: [[f64; 2]; 4] = roots_f64();

/// The power of each bin below half of the sample rate.
#[function]
pub fn powers(samples: &[f32; 16]) -> [f32; 8] {
    let (mut re, mut im) = (*samples, [0.0; 16]);
    fft(&mut re, &mut im, &ROOTS);
    let mut powers = [0.0; 8];
    for (k, power) in powers.iter_mut().enumerate() {
        *power = re[k] * re[k] + im[k] * im[k];
    }
    powers
}

/// A transform of eight complex points, in place.
#[function]
pub fn transformed(re: &mut [f64; 8], im: &mut [f64; 8]) {
    fft(re, im, &FINE_ROOTS);
}

/// The power of a tone, `cycles` of which are in a sample period.
#[function]
pub fn tone(samples: &[f32; 16], cycles: f32) -> f32 {
    goertzel(samples, cycles)
}
