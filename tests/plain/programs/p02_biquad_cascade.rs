//! Cascade of second-order sections (transposed direct form II) with the usual
//! audio-cookbook designs and a Butterworth low-pass of order `2 * N`.

use core::f32::consts::{PI, TAU};

/// Filter shapes that [`Coeffs::design`] knows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    LowPass,
    HighPass,
    BandPass,
    Notch,
    Peak { gain_db: f32 },
}

/// Normalised coefficients, `a0 == 1`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coeffs {
    pub b: [f32; 3],
    pub a: [f32; 2],
}

impl Coeffs {
    /// Passes the signal through untouched.
    pub const IDENTITY: Self = Self { b: [1.0, 0.0, 0.0], a: [0.0, 0.0] };

    /// Designs one section; `None` when the frequency is not below Nyquist or
    /// `q` is not positive.
    pub fn design(shape: Shape, fs: f32, f0: f32, q: f32) -> Option<Self> {
        if !(f0 > 0.0 && f0 < 0.5 * fs && q > 0.0) {
            return None;
        }
        let (sin, cos) = (TAU * f0 / fs).sin_cos();
        let alpha = sin / (2.0 * q);
        let (b, a) = match shape {
            Shape::LowPass => {
                let k = 1.0 - cos;
                ([0.5 * k, k, 0.5 * k], [1.0 + alpha, -2.0 * cos, 1.0 - alpha])
            }
            Shape::HighPass => {
                let k = 1.0 + cos;
                ([0.5 * k, -k, 0.5 * k], [1.0 + alpha, -2.0 * cos, 1.0 - alpha])
            }
            Shape::BandPass => ([alpha, 0.0, -alpha], [1.0 + alpha, -2.0 * cos, 1.0 - alpha]),
            Shape::Notch => ([1.0, -2.0 * cos, 1.0], [1.0 + alpha, -2.0 * cos, 1.0 - alpha]),
            Shape::Peak { gain_db } => {
                let amp = 10.0_f32.powf(gain_db / 40.0);
                (
                    [1.0 + alpha * amp, -2.0 * cos, 1.0 - alpha * amp],
                    [1.0 + alpha / amp, -2.0 * cos, 1.0 - alpha / amp],
                )
            }
        };
        let [a0, a1, a2] = a;
        Some(Self { b: b.map(|v| v / a0), a: [a1 / a0, a2 / a0] })
    }
}

impl Default for Coeffs {
    fn default() -> Self {
        Self::IDENTITY
    }
}

#[derive(Clone, Copy, Debug, Default)]
struct Section {
    coeffs: Coeffs,
    s1: f32,
    s2: f32,
}

impl Section {
    fn step(&mut self, x: f32) -> f32 {
        let Coeffs { b, a } = &self.coeffs;
        let y = b[0] * x + self.s1;
        self.s1 = b[1] * x - a[0] * y + self.s2;
        self.s2 = b[2] * x - a[1] * y;
        y
    }
}

/// `N` sections in series.
#[derive(Clone, Debug)]
pub struct Cascade<const N: usize> {
    sections: [Section; N],
}

impl<const N: usize> Cascade<N> {
    pub fn new(coeffs: [Coeffs; N]) -> Self {
        Self { sections: coeffs.map(|coeffs| Section { coeffs, ..Section::default() }) }
    }

    /// Butterworth low-pass of order `2 * N`.
    pub fn butterworth_lowpass(fs: f32, fc: f32) -> Option<Self> {
        let mut coeffs = [Coeffs::IDENTITY; N];
        for (k, c) in coeffs.iter_mut().enumerate() {
            let angle = PI * (2 * k + 1) as f32 / (4 * N) as f32;
            *c = Coeffs::design(Shape::LowPass, fs, fc, 0.5 / angle.cos())?;
        }
        Some(Self::new(coeffs))
    }

    pub fn step(&mut self, x: f32) -> f32 {
        self.sections.iter_mut().fold(x, |v, s| s.step(v))
    }

    /// Filters a block in place.
    pub fn process(&mut self, block: &mut [f32]) {
        block.iter_mut().for_each(|v| *v = self.step(*v));
    }

    pub fn reset(&mut self) {
        for Section { s1, s2, .. } in &mut self.sections {
            *s1 = 0.0;
            *s2 = 0.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gain_at<const N: usize>(f: &mut Cascade<N>, fs: f32, freq: f32) -> f32 {
        f.reset();
        (0..4000)
            .map(|n| (n, f.step((TAU * freq * n as f32 / fs).sin())))
            .filter(|&(n, _)| n > 3000)
            .map(|(_, y)| y.abs())
            .fold(0.0, f32::max)
    }

    #[test]
    fn fourth_order_butterworth() {
        let mut lp = Cascade::<2>::butterworth_lowpass(1000.0, 50.0).unwrap();
        assert!((gain_at(&mut lp, 1000.0, 5.0) - 1.0).abs() < 0.01);
        assert!((gain_at(&mut lp, 1000.0, 50.0) - 0.707).abs() < 0.01);
        assert!(gain_at(&mut lp, 1000.0, 200.0) < 0.01);
    }

    #[test]
    fn notch_removes_hum() {
        let notch = Coeffs::design(Shape::Notch, 1000.0, 50.0, 5.0).unwrap();
        let peak = Coeffs::design(Shape::Peak { gain_db: 6.0 }, 1000.0, 120.0, 2.0).unwrap();
        let mut f = Cascade::new([notch, peak]);
        assert!(gain_at(&mut f, 1000.0, 50.0) < 0.01);
        assert!(gain_at(&mut f, 1000.0, 120.0) > 1.8);
    }

    #[test]
    fn bad_designs_are_refused() {
        assert!(Coeffs::design(Shape::HighPass, 1000.0, 600.0, 0.7).is_none());
        let mut block = [1.0, 2.0, 3.0];
        Cascade::new([Coeffs::default(); 3]).process(&mut block);
        assert_eq!(block, [1.0, 2.0, 3.0]);
    }
}
