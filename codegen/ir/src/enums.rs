//! Numbers of an enum's variants: the value of `mode as u8`, and the number after `=` in the C.
//!
//! The word of a variant is its index, whatever its number is; this module converts between them.

use core::ops::RangeInclusive;

use crate::ir::Enum;

impl Enum {
    /// Returns the number of a variant, by its word.
    pub fn value(&self, word: u64) -> Option<i32> {
        usize::try_from(word).ok().and_then(|at| self.variants.get(at)).map(|it| it.value)
    }

    /// Returns the least and the greatest number of the variants in a range of words.
    pub fn values(&self, words: RangeInclusive<usize>) -> Option<(i32, i32)> {
        let numbers = self.variants.get(words)?.iter().map(|variant| variant.value);
        Some((numbers.clone().min()?, numbers.max()?))
    }

    /// Returns the index of the variant as which a value counts in the C that is no variant: the author's choice, or
    /// the last.
    pub fn fallback(&self) -> usize {
        let chosen = self.variants.iter().position(|variant| variant.given.fallback);
        chosen.unwrap_or(self.variants.len().saturating_sub(1))
    }

    /// Returns true if the author chose the variant as which an invalid value counts.
    pub fn has_fallback(&self) -> bool {
        self.variants.iter().any(|variant| variant.given.fallback)
    }

    /// Returns true if the author's numbers of the variants differ from 0, 1, 2 …
    pub fn is_numbered(&self) -> bool {
        (0..).zip(&self.variants).any(|(index, variant)| variant.value != index)
    }
}
