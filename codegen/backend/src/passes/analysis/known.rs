//! Facts about one word, and about the words in a value.
//!
//! Must not know: the place of the word, or the origin of a fact.

use super::bounds::Bounds;
use super::domain::Interval;

/// Pseudo-field of a [`Key`](super::state::Key) that denotes the normalised variant of the enum.
pub(super) const BROUGHT: u32 = u32::MAX;

/// Fact about the word at a place.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Known {
    /// The word is in the interval.
    Within(Interval),
    /// The word is this float, and not a NaN.
    Float(f64),
    /// The word is a float between these bounds.
    Between(Bounds),
}

impl PartialEq for Known {
    /// Returns true if two facts say the same: of two zeros they do not.
    fn eq(&self, other: &Known) -> bool {
        match (self, other) {
            (Known::Within(a), Known::Within(b)) => a == b,
            (Known::Float(a), Known::Float(b)) => a.to_bits() == b.to_bits(),
            (Known::Between(a), Known::Between(b)) => a == b,
            _ => false,
        }
    }
}

impl Known {
    /// Returns the bounds of a float.
    pub(super) fn bounds(self) -> Option<Bounds> {
        match self {
            Known::Within(_) => None,
            Known::Float(value) => Some(Bounds::one(value)),
            Known::Between(bounds) => Some(bounds),
        }
    }

    /// Returns what holds of a word of which this or `other` does; none if that is nothing.
    pub(super) fn or(self, other: Known) -> Option<Known> {
        match (self, other) {
            (Known::Within(a), Known::Within(b)) => Some(Known::Within(a.join(b))),
            (Known::Float(_), Known::Float(_)) if self == other => Some(self),
            _ => Known::between(self.bounds()?.join(other.bounds()?)),
        }
    }

    /// Returns the fact that a float has these bounds; none if every float has.
    pub(super) fn between(bounds: Bounds) -> Option<Known> {
        (bounds != Bounds::ANY).then_some(Known::Between(bounds))
    }
}

/// Facts about the words in a value, each with the fields that lead to it.
pub(crate) type Parts = Vec<(Vec<u32>, Known)>;

/// Returns the fact about the value itself, if it is a word.
pub(crate) fn the_whole(parts: &Parts) -> Option<Known> {
    parts.iter().find(|(at, _)| at.is_empty()).map(|(_, known)| *known)
}
