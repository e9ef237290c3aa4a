//! Radix-2 FFT of 64 points on `Complex<f32>` with a windowed spectrum and a
//! search for the dominant line.

use core::f32::consts::TAU;
use nalgebra::Complex;

pub const LEN: usize = 64;
const STAGES: u32 = LEN.trailing_zeros();

type C32 = Complex<f32>;

/// Tables for the transform; make one at start-up.
#[derive(Clone, Debug)]
pub struct Fft64 {
    twiddle: [C32; LEN / 2],
    window: [f32; LEN],
}

/// A spectral line found by [`Fft64::dominant`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    pub bin: usize,
    /// Frequency interpolated between bins, as a share of the sample rate.
    pub frequency: f32,
    pub power: f32,
}

impl Fft64 {
    pub fn new() -> Self {
        let step = TAU / LEN as f32;
        Self {
            twiddle: core::array::from_fn(|k| {
                let (sin, cos) = (step * k as f32).sin_cos();
                C32::new(cos, -sin)
            }),
            window: core::array::from_fn(|n| 0.5 - 0.5 * (step * n as f32).cos()),
        }
    }

    /// Forward transform in place.
    pub fn forward(&self, data: &mut [C32; LEN]) {
        for i in 0..LEN {
            let j = (i as u32).reverse_bits() >> (u32::BITS - STAGES);
            let j = j as usize;
            if i < j {
                data.swap(i, j);
            }
        }
        let mut half = 1;
        while half < LEN {
            let stride = LEN / (2 * half);
            for block in data.chunks_exact_mut(2 * half) {
                let (low, high) = block.split_at_mut(half);
                let twiddles = self.twiddle.iter().step_by(stride);
                for ((a, b), w) in low.iter_mut().zip(high).zip(twiddles) {
                    let t = *b * w;
                    *b = *a - t;
                    *a += t;
                }
            }
            half *= 2;
        }
    }

    /// Inverse transform by conjugation, scaled by 1/N.
    pub fn inverse(&self, data: &mut [C32; LEN]) {
        data.iter_mut().for_each(|c| *c = c.conj());
        self.forward(data);
        data.iter_mut().for_each(|c| *c = c.conj() / LEN as f32);
    }

    /// Hann-windowed power spectrum of real samples, mean removed.
    pub fn power_spectrum(&self, samples: &[f32; LEN]) -> [f32; LEN / 2] {
        let mean = samples.iter().sum::<f32>() / LEN as f32;
        let mut buf = [C32::default(); LEN];
        for ((c, x), w) in buf.iter_mut().zip(samples).zip(&self.window) {
            *c = C32::new((x - mean) * w, 0.0);
        }
        self.forward(&mut buf);
        core::array::from_fn(|k| buf[k].norm_sqr())
    }

    /// Strongest line above `floor` with parabolic interpolation.
    pub fn dominant(&self, samples: &[f32; LEN], floor: f32) -> Option<Line> {
        let spectrum = self.power_spectrum(samples);
        let (bin, &power) = spectrum
            .iter()
            .enumerate()
            .skip(1)
            .max_by(|a, b| a.1.total_cmp(b.1))
            .filter(|&(_, &p)| p > floor)?;
        let left = spectrum[bin - 1].sqrt();
        let right = spectrum.get(bin + 1).copied().unwrap_or_default().sqrt();
        let mid = power.sqrt();
        let denominator = left - 2.0 * mid + right;
        let shift = if denominator.abs() > f32::EPSILON {
            0.5 * (left - right) / denominator
        } else {
            0.0
        };
        Some(Line { bin, frequency: (bin as f32 + shift) / LEN as f32, power })
    }
}

impl Default for Fft64 {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impulse_is_flat_and_round_trip_holds() {
        let fft = Fft64::new();
        let mut data = [C32::default(); LEN];
        data[0] = C32::new(1.0, 0.0);
        fft.forward(&mut data);
        assert!(data.iter().all(|c| (c - C32::new(1.0, 0.0)).norm_sqr() < 1e-10));

        let original: [C32; LEN] = core::array::from_fn(|n| C32::new(n as f32, 3.0 - n as f32 * 0.5));
        let mut work = original;
        fft.forward(&mut work);
        fft.inverse(&mut work);
        assert!(work.iter().zip(&original).all(|(a, b)| (a - b).norm_sqr() < 1e-6));
    }

    #[test]
    fn finds_an_off_bin_tone() {
        let fft = Fft64::default();
        let samples = core::array::from_fn(|n| 1.0 + (TAU * 0.157 * n as f32).sin());
        let line = fft.dominant(&samples, 1.0).unwrap();
        assert_eq!(line.bin, 10);
        assert!((line.frequency - 0.157).abs() < 0.002, "{line:?}");
    }

    #[test]
    fn silence_has_no_line() {
        assert_eq!(Fft64::new().dominant(&[0.25; LEN], 1e-3), None);
    }
}
