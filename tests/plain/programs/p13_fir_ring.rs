//! FIR filter on a ring buffer, generic over the sample type, a windowed-sinc
//! design for `f32` and a decimator.

use core::iter::Sum;
use core::ops::Mul;

/// What a sample must be able to do.
pub trait Sample: Copy + Default + Mul<Output = Self> + Sum {}
impl<T: Copy + Default + Mul<Output = T> + Sum> Sample for T {}

/// FIR filter of `N` taps.
#[derive(Clone, Debug)]
pub struct Fir<T, const N: usize> {
    taps: [T; N],
    history: [T; N],
    head: usize,
}

impl<T: Sample, const N: usize> Fir<T, N> {
    pub fn new(taps: [T; N]) -> Self {
        const { assert!(N > 0, "a filter needs at least one tap") };
        Self { taps, history: [T::default(); N], head: 0 }
    }

    /// Stores a sample without computing an output.
    pub fn feed(&mut self, x: T) {
        self.head = if self.head == 0 { N - 1 } else { self.head - 1 };
        self.history[self.head] = x;
    }

    /// Output for the samples so far, newest first against the taps.
    pub fn output(&self) -> T {
        let (wrapped, newest) = self.history.split_at(self.head);
        newest
            .iter()
            .chain(wrapped)
            .zip(&self.taps)
            .map(|(&x, &h)| x * h)
            .sum()
    }

    pub fn step(&mut self, x: T) -> T {
        self.feed(x);
        self.output()
    }
}

impl<const N: usize> Fir<f32, N> {
    /// Hamming-windowed sinc with unity gain at DC; cutoff as a share of the
    /// sample rate.
    pub fn lowpass(cutoff: f32) -> Self {
        use core::f32::consts::{PI, TAU};

        let centre = (N - 1) as f32 / 2.0;
        let mut taps: [f32; N] = core::array::from_fn(|n| {
            let x = n as f32 - centre;
            let sinc = match x {
                0.0 => 2.0 * cutoff,
                _ => (TAU * cutoff * x).sin() / (PI * x),
            };
            let window = if N > 1 {
                0.54 - 0.46 * (TAU * n as f32 / (N - 1) as f32).cos()
            } else {
                1.0
            };
            sinc * window
        });
        let gain: f32 = taps.iter().sum();
        taps.iter_mut().for_each(|t| *t /= gain);
        Self::new(taps)
    }
}

/// Anti-alias filter followed by taking every `M`-th sample.
#[derive(Clone, Debug)]
pub struct Decimator<const N: usize, const M: usize> {
    fir: Fir<f32, N>,
    phase: usize,
}

impl<const N: usize, const M: usize> Decimator<N, M> {
    pub fn new() -> Self {
        Self { fir: Fir::lowpass(0.4 / M as f32), phase: 0 }
    }

    pub fn push(&mut self, x: f32) -> Option<f32> {
        self.fir.feed(x);
        self.phase = (self.phase + 1) % M;
        (self.phase == 0).then(|| self.fir.output())
    }
}

impl<const N: usize, const M: usize> Default for Decimator<N, M> {
    fn default() -> Self {
        Self::new()
    }
}

/// The front end of the vibration channel: 31 taps, 4 to 1.
pub type VibrationFrontEnd = Decimator<31, 4>;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impulse_response_is_the_taps() {
        let mut fir = Fir::new([3_i32, -1, 4, 1]);
        let out: [i32; 6] = core::array::from_fn(|n| fir.step((n == 0).into()));
        assert_eq!(out, [3, -1, 4, 1, 0, 0]);
    }

    #[test]
    fn lowpass_passes_dc_and_stops_high() {
        let mut fir = Fir::<f32, 31>::lowpass(0.1);
        let dc = (0..64).map(|_| fir.step(1.0)).last().unwrap();
        assert!((dc - 1.0).abs() < 1e-5);
        let ripple = (0..200)
            .map(|n| fir.step(if n % 2 == 0 { 1.0 } else { -1.0 }))
            .skip(64)
            .fold(0.0_f32, |m, y| m.max(y.abs()));
        assert!(ripple < 0.01, "{ripple}");
    }

    #[test]
    fn decimator_gives_every_fourth() {
        let mut dec = VibrationFrontEnd::new();
        assert_eq!((0..100).filter_map(|_| dec.push(2.0)).count(), 25);
        let last = (0..4).find_map(|_| dec.push(2.0)).unwrap();
        assert!((last - 2.0).abs() < 1e-4);
    }
}
