//! Sections of Butterworth and Chebyshev filters, for the cascades of `bessemer-blocks`.
//!
//! Frequencies are in Hz, above 0 and below half of the `rate`, the samples per second. Sections are in order of rising quality,
//! so that none before the last amplifies much. Each has gain 1 in its pass band.
//!
//! Source: Oppenheim and Schafer, *Discrete-Time Signal Processing*, 3rd edition, appendix B.

use std::f64::consts::PI;

use bessemer_blocks::Section;

/// Kinds of filters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Passes lower frequencies.
    LowPass,
    /// Passes higher frequencies.
    HighPass,
}

/// Returns the sections of a Butterworth filter: flat in the pass band, −3 dB at the frequency.
///
/// An odd order has one section of first order.
pub fn butterworth(kind: Kind, order: usize, frequency: f64, rate: f64) -> Vec<Section<f64>> {
    let poles = (0..order.div_ceil(2)).rev().map(|k| {
        let angle = PI * (2 * k + 1) as f64 / (2 * order) as f64;
        (angle.sin(), angle.cos())
    });
    sections(kind, order, frequency, rate, poles)
}

/// Returns the sections of a Chebyshev filter of type I: its gain is within `ripple` dB below 1 up to the frequency.
pub fn chebyshev(
    kind: Kind,
    order: usize,
    ripple: f64,
    frequency: f64,
    rate: f64,
) -> Vec<Section<f64>> {
    let epsilon = (10_f64.powf(ripple / 10.0) - 1.0).sqrt();
    let width = (1.0 / epsilon).asinh() / order as f64;
    let poles = (0..order.div_ceil(2)).rev().map(|k| {
        let angle = PI * (2 * k + 1) as f64 / (2 * order) as f64;
        (width.sinh() * angle.sin(), width.cosh() * angle.cos())
    });
    let mut sections = sections(kind, order, frequency, rate, poles);
    // An even order begins at the bottom of the ripple.
    if let Some(first) = sections.first_mut().filter(|_| order.is_multiple_of(2)) {
        let gain = 1.0 / (1.0 + epsilon * epsilon).sqrt();
        (first.b0, first.b1, first.b2) = (first.b0 * gain, first.b1 * gain, first.b2 * gain);
    }
    sections
}

/// Returns the sections of poles −re ± i im of a low-pass at 1 rad/s, by the bilinear transform with prewarping.
fn sections(
    kind: Kind,
    order: usize,
    frequency: f64,
    rate: f64,
    poles: impl Iterator<Item = (f64, f64)>,
) -> Vec<Section<f64>> {
    let w = (PI * frequency / rate).tan();
    let section = |(index, (re, im)): (usize, (f64, f64))| {
        // 1/(s²/size + 2 re s/size + 1), or 1/(s/re + 1) for the real pole of an odd order; s becomes 1/s for a
        // high-pass.
        let (first, second) = match index == 0 && !order.is_multiple_of(2) {
            true => (1.0 / re, 0.0),
            false => (2.0 * re / (re * re + im * im), 1.0 / (re * re + im * im)),
        };
        let (c0, c1, c2) = match kind {
            Kind::LowPass => (w * w, first * w, second),
            Kind::HighPass => (second * w * w, first * w, 1.0),
        };
        if second == 0.0 {
            let (c0, c1) = match kind {
                Kind::LowPass => (w, first),
                Kind::HighPass => (first * w, 1.0),
            };
            let scale = 1.0 / (c0 + c1);
            let (b0, b1) = match kind {
                Kind::LowPass => (w * scale, w * scale),
                Kind::HighPass => (scale, -scale),
            };
            return Section { b0, b1, b2: 0.0, a1: (c0 - c1) * scale, a2: 0.0 };
        }
        let scale = 1.0 / (c0 + c1 + c2);
        let (b0, b1) = match kind {
            Kind::LowPass => (w * w * scale, 2.0 * w * w * scale),
            Kind::HighPass => (scale, -2.0 * scale),
        };
        Section { b0, b1, b2: b0, a1: 2.0 * (c0 - c2) * scale, a2: (c0 - c1 + c2) * scale }
    };
    poles.enumerate().map(section).collect()
}
