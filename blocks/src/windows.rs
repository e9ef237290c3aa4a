//! Filters over the last samples: finite impulse response, moving average and variance, decimation.
//!
//! The samples are an array of constant length N, at least 1. A NaN leaves the window after N samples.

use bessemer::prelude::*;

/// Filter with a finite impulse response: y(k) = Σ taps[i] u(k−i), i from 0 to N − 1.
///
/// The sum begins with the oldest sample. Initialisation: `Default` has zeros. Nothing saturates.
///
/// ```
/// let mut filter = bessemer_blocks::Fir::<f64, 3>::default();
/// let taps = [0.5, 0.25, 0.125];
/// assert_eq!([8.0, 0.0, 0.0, 0.0].map(|sample| filter.step(&taps, sample)), [4.0, 2.0, 1.0, 0.0]);
/// ```
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fir<T, const N: usize> {
    /// The last samples, newest first.
    samples: [T; N],
}

impl<T: Real, const N: usize> Default for Fir<T, N> {
    fn default() -> Self {
        Fir { samples: [T::ZERO; N] }
    }
}

#[component]
impl<T: Real, const N: usize> Fir<T, N> {
    /// Filters one sample.
    #[entry(infallible)]
    pub fn step(&mut self, taps: &[T; N], sample: T) -> T {
        let mut sum = T::ZERO;
        for k in (1..N).rev() {
            self.samples[k] = self.samples[k - 1];
            sum += taps[k] * self.samples[k];
        }
        self.samples[0] = sample;
        sum + taps[0] * sample
    }
}

/// Decimator: a low-pass with a finite impulse response whose output is computed for one sample in `factor`.
///
/// The first output comes with the first sample. The taps remove what lies above half of the lower rate.
/// Initialisation: `Default` has zeros. Nothing saturates.
///
/// ```
/// let mut decimator = bessemer_blocks::Decimator::<f32, 2>::default();
/// let outputs = [2.0, 4.0, 6.0].map(|sample| decimator.step(&[0.5, 0.5], 2, sample));
/// assert_eq!(outputs, [Some(1.0), None, Some(5.0)]);
/// ```
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decimator<T, const N: usize> {
    /// The last samples.
    samples: [T; N],
    /// Index of the newest.
    newest: u32,
    /// Number of samples before the next output.
    wait: u32,
}

impl<T: Real, const N: usize> Default for Decimator<T, N> {
    fn default() -> Self {
        Decimator { samples: [T::ZERO; N], newest: 0, wait: 0 }
    }
}

#[component]
impl<T: Real, const N: usize> Decimator<T, N> {
    /// Takes one sample; returns an output with one sample in `factor`. A factor of 0 means 1.
    #[entry(infallible)]
    pub fn step(&mut self, taps: &[T; N], factor: u32, sample: T) -> Option<T> {
        self.newest = (self.newest % N as u32 + 1) % N as u32;
        self.samples[self.newest as usize] = sample;
        if self.wait > 0 {
            self.wait -= 1;
            return None;
        }
        self.wait = factor.saturating_sub(1);
        let (mut sum, mut index) = (T::ZERO, self.newest);
        for tap in taps {
            let here = index.min(N as u32 - 1);
            sum += *tap * self.samples[here as usize];
            index = if here == 0 { N as u32 - 1 } else { here - 1 };
        }
        Some(sum)
    }
}

/// Mean and variance of a window.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread<T> {
    /// The mean, U.
    pub mean: T,
    /// The unbiased variance, U²: divided by N − 1; 0 for N = 1.
    pub variance: T,
}

/// Moving average and variance of the last N samples of unit U.
///
/// Each step adds up the window, so no rounding error remains in the state. Initialisation: the first sample fills
/// the window. Nothing saturates.
///
/// ```
/// use bessemer_blocks::{Moving, Spread};
///
/// let mut moving = Moving::<f32, 4>::default();
/// assert_eq!(moving.average(2.0), 2.0);
/// assert_eq!(moving.average(6.0), 3.0);
/// assert_eq!(moving.spread(6.0), Spread { mean: 4.0, variance: 16.0 / 3.0 });
/// ```
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moving<T, const N: usize> {
    /// The samples, of which the oldest is replaced next.
    samples: [T; N],
    /// Index of the oldest.
    oldest: u32,
    /// True after the first sample.
    filled: bool,
}

impl<T: Real, const N: usize> Default for Moving<T, N> {
    fn default() -> Self {
        Moving { samples: [T::ZERO; N], oldest: 0, filled: false }
    }
}

#[component]
impl<T: Real, const N: usize> Moving<T, N> {
    /// Takes one sample; returns the mean.
    #[entry(infallible)]
    pub fn average(&mut self, sample: T) -> T {
        self.take(sample);
        self.mean()
    }

    /// Takes one sample; returns the mean and the variance.
    #[entry(infallible)]
    pub fn spread(&mut self, sample: T) -> Spread<T> {
        self.take(sample);
        let mean = self.mean();
        let mut sum = T::ZERO;
        for sample in &self.samples {
            let off = *sample - mean;
            sum += off * off;
        }
        let variance = if N > 1 { sum / (real::<T>(N as f64) - T::ONE) } else { T::ZERO };
        Spread { mean, variance }
    }

    /// Replaces the oldest sample.
    fn take(&mut self, sample: T) {
        if !self.filled {
            self.samples = [sample; N];
            self.filled = true;
        }
        let oldest = self.oldest % N as u32;
        self.samples[oldest as usize] = sample;
        self.oldest = (oldest + 1) % N as u32;
    }

    /// Returns the mean of the window.
    fn mean(&self) -> T {
        let mut sum = T::ZERO;
        for sample in &self.samples {
            sum += *sample;
        }
        sum / real(N as f64)
    }
}
