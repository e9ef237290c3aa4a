//! Goertzel's algorithm: the power of one tone in a block of samples.

use bessemer::prelude::*;

/// The power of a tone with `periods` periods in the block.
#[function]
pub fn power(samples: &[f32], periods: f32) -> f32 {
    let coefficient = 2.0 * (core::f32::consts::TAU * periods / samples.len() as f32).cos();
    let (mut before, mut last) = (0.0, 0.0);
    for sample in samples {
        (before, last) = (last, sample + coefficient * last - before);
    }
    before * before + last * last - coefficient * before * last
}

/// The strongest of the tones with one to four periods.
#[function]
pub fn strongest(samples: &[f32; 16]) -> Option<usize> {
    let powers = core::array::from_fn::<f32, 4, _>(|k| power(samples, (k + 1) as f32));
    let most = powers.iter().copied().fold(0.0, f32::max);
    powers.iter().position(|power| *power >= most)
}
