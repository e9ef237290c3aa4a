//! The numbers of an enum's variants: what `mode as u8` gives, and what the C writes behind `=`.
//!
//! A variant's word is its index, whatever its number; between the two this module translates.

use core::ops::RangeInclusive;

use crate::ir::Enum;

impl Enum {
    /// The number of a variant, by its word.
    pub fn value(&self, word: u64) -> Option<i32> {
        usize::try_from(word).ok().and_then(|at| self.variants.get(at)).map(|it| it.value)
    }

    /// The least and the greatest number among the variants of some words.
    pub fn values(&self, words: RangeInclusive<usize>) -> Option<(i32, i32)> {
        let numbers = self.variants.get(words)?.iter().map(|variant| variant.value);
        Some((numbers.clone().min()?, numbers.max()?))
    }

    /// Returns true if the author's numbers of the variants differ from 0, 1, 2 …
    pub fn is_numbered(&self) -> bool {
        (0..).zip(&self.variants).any(|(index, variant)| variant.value != index)
    }
}
