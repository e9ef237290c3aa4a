//! Facts about one word, and about the words in a value.
//!
//! It must not know where the word is, nor how it came to be known.

use super::domain::Interval;

/// In a [`Key`](super::state::Key), this marks not a field but the variant that represents the enum there.
pub(super) const BROUGHT: u32 = u32::MAX;

/// Knowledge of the word at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Known {
    /// It lies within.
    Within(Interval),
    /// It is this float; not a NaN.
    Float(f64),
}

/// The words in a value that are known, each with the fields that lead to it.
pub(crate) type Parts = Vec<(Vec<u32>, Known)>;

/// The part that is the value itself: there is one if the value is a word, and its number is known.
pub(crate) fn the_whole(parts: &Parts) -> Option<Known> {
    parts.iter().find(|(at, _)| at.is_empty()).map(|(_, known)| *known)
}
