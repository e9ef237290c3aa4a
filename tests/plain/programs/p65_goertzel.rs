//! Bank of Goertzel detectors, as used for DTMF or pilot tones.

use core::f32::consts::TAU;
use nalgebra::ComplexField;

#[derive(Debug, Clone, Copy, Default)]
struct Goertzel {
    coefficient: f32,
    s1: f32,
    s2: f32,
}

impl Goertzel {
    fn new(frequency: f32, sample_rate: f32) -> Self {
        Self { coefficient: 2.0 * (TAU * frequency / sample_rate).cos(), ..Self::default() }
    }

    fn push(&mut self, sample: f32) {
        let s0 = sample + self.coefficient * self.s1 - self.s2;
        self.s2 = self.s1;
        self.s1 = s0;
    }

    fn take_power(&mut self) -> f32 {
        let Self { coefficient, s1, s2 } = *self;
        self.s1 = 0.0;
        self.s2 = 0.0;
        s1 * s1 + s2 * s2 - coefficient * s1 * s2
    }
}

/// Powers of one block, relative to the total power of the block: a pure
/// tone in the middle of its bin reads 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spectrum<const N: usize> {
    pub relative: [f32; N],
    pub mean_square: f32,
}

impl<const N: usize> Spectrum<N> {
    /// Strongest tone within a range of channels, if it exceeds `threshold`
    /// and clearly dominates all others in the range.
    pub fn dominant(&self, channels: core::ops::Range<usize>, threshold: f32) -> Option<usize> {
        const DOMINANCE: f32 = 4.0;
        let candidates =
            || self.relative.iter().enumerate().skip(channels.start).take(channels.len());

        let (best, &power) = candidates().max_by(|a, b| a.1.total_cmp(b.1))?;
        let alone =
            candidates().filter(|&(i, _)| i != best).all(|(_, &other)| other * DOMINANCE < power);
        (alone && power > threshold).then_some(best)
    }
}

/// `N` detectors that share a block length.
pub struct ToneBank<const N: usize> {
    detectors: [Goertzel; N],
    block: usize,
    filled: usize,
    energy: f32,
}

impl<const N: usize> ToneBank<N> {
    pub fn new(frequencies: [f32; N], sample_rate: f32, block: usize) -> Self {
        Self {
            detectors: frequencies.map(|f| Goertzel::new(f, sample_rate)),
            block,
            filled: 0,
            energy: 0.0,
        }
    }

    /// Feeds one sample; the last of a block yields its spectrum.
    pub fn push(&mut self, sample: f32) -> Option<Spectrum<N>> {
        for detector in &mut self.detectors {
            detector.push(sample);
        }
        self.energy += sample * sample;
        self.filled += 1;
        (self.filled == self.block).then(|| self.finish_block())
    }

    fn finish_block(&mut self) -> Spectrum<N> {
        let energy = core::mem::take(&mut self.energy);
        let samples = core::mem::take(&mut self.filled) as f32;
        let norm = if energy > 0.0 { 2.0 / (energy * samples) } else { 0.0 };
        Spectrum {
            relative: self.detectors.each_mut().map(|d| d.take_power() * norm),
            mean_square: energy / samples,
        }
    }

    /// Spectra of all complete blocks in a stream of samples.
    pub fn spectra<'a>(
        &'a mut self,
        samples: impl IntoIterator<Item = f32> + 'a,
    ) -> impl Iterator<Item = Spectrum<N>> + 'a {
        samples.into_iter().filter_map(|sample| self.push(sample))
    }
}

pub const DTMF: [f32; 8] = [697.0, 770.0, 852.0, 941.0, 1209.0, 1336.0, 1477.0, 1633.0];

/// The key of a DTMF spectrum, one row tone and one column tone.
pub fn dtmf_key(spectrum: &Spectrum<8>) -> Option<char> {
    const KEYS: [[char; 4]; 4] =
        [['1', '2', '3', 'A'], ['4', '5', '6', 'B'], ['7', '8', '9', 'C'], ['*', '0', '#', 'D']];
    const SILENCE: f32 = 1e-4;

    if spectrum.mean_square < SILENCE {
        return None;
    }
    let row = spectrum.dominant(0..4, 0.25)?;
    let column = spectrum.dominant(4..8, 0.25)?;
    Some(KEYS[row][column - 4])
}
