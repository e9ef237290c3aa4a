//! Values as words, 64 bits each in the order of [`Plain`]: what is compared between the ways in which a model is carried
//! out.
//!
//! What it must not know: those ways. The simulation compares words, and is not built again with the compiler.

use bessemer::Plain;

/// The words of a value.
pub fn words(value: &impl Plain) -> Vec<u64> {
    let mut words = Vec::new();
    value.store(&mut |word| words.push(word));
    words
}

/// The value of words.
pub fn value<T: Plain>(words: &[u64]) -> T {
    let mut words = words.iter().copied();
    T::load(&mut || words.next().unwrap_or_default())
}

/// Many words as one (FNV-1a), to compare what is too much to keep. Any NaN counts as any other.
pub fn digest(words: &[u64]) -> u64 {
    let plain = |word: &u64| if f64::from_bits(*word).is_nan() { u64::MAX } else { *word };
    words.iter().fold(0xCBF2_9CE4_8422_2325, |sum, word| {
        (sum ^ plain(word)).wrapping_mul(0x0000_0100_0000_01B3)
    })
}
