//! Facts about one word, and about the words in a value.
//!
//! Must not know: the place of the word, or the origin of a fact.

use super::domain::Interval;

/// Pseudo-field of a [`Key`](super::state::Key) that denotes the normalised variant of the enum.
pub(super) const BROUGHT: u32 = u32::MAX;

/// Fact about the word at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Known {
    /// The word is in the interval.
    Within(Interval),
    /// The word is this float, and not a NaN.
    Float(f64),
}

/// Facts about the words in a value, each with the fields that lead to it.
pub(crate) type Parts = Vec<(Vec<u32>, Known)>;

/// Returns the fact about the value itself, if it is a word.
pub(crate) fn the_whole(parts: &Parts) -> Option<Known> {
    parts.iter().find(|(at, _)| at.is_empty()).map(|(_, known)| *known)
}
