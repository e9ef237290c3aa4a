//! Values as words, 64 bits each in the order of [`Plain`]: the form in which results of different legs are compared.
//!
//! What it must not know: the legs. The simulation compares words, too, and is not rebuilt with the compiler.

use bessemer::Plain;

pub mod record;

/// Returns the words of a value.
pub fn words(value: &impl Plain) -> Vec<u64> {
    let mut words = Vec::new();
    value.store(&mut |word| words.push(word));
    words
}

/// Builds a value from words.
pub fn value<T: Plain>(words: &[u64]) -> T {
    let mut words = words.iter().copied();
    T::load(&mut || words.next().unwrap_or_default())
}

/// Returns a hash of many words (FNV-1a), for comparing results that are too large to store. All NaN count as equal.
pub fn digest(words: &[u64]) -> u64 {
    let plain = |word: &u64| if f64::from_bits(*word).is_nan() { u64::MAX } else { *word };
    words.iter().fold(0xCBF2_9CE4_8422_2325, |sum, word| {
        (sum ^ plain(word)).wrapping_mul(0x0000_0100_0000_01B3)
    })
}
