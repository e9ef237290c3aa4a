//! Bounds of a float: the lattice, as [`domain`](super::domain) is that of integers.
//!
//! Bounds mean the set of the floats between them and, if it [may be one](Bounds::nan), NaN. The order is inclusion.

/// The bounds of a float.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub(super) low: f64,
    pub(super) high: f64,
    /// True if it may be a NaN.
    pub(super) nan: bool,
}

impl Bounds {
    pub(super) const ANY: Bounds =
        Bounds { low: f64::NEG_INFINITY, high: f64::INFINITY, nan: true };

    pub(super) fn one(value: f64) -> Bounds {
        Bounds { low: value, high: value, nan: false }
    }

    pub(super) fn join(self, other: Bounds) -> Bounds {
        let (low, high) = (self.low.min(other.low), self.high.max(other.high));
        Bounds { low, high, nan: self.nan || other.nan }
    }

    /// Returns the bounds without each end that `next` moves.
    pub(super) fn widened(self, next: Bounds) -> Bounds {
        Bounds {
            low: if next.low < self.low { f64::NEG_INFINITY } else { self.low },
            high: if next.high > self.high { f64::INFINITY } else { self.high },
            nan: self.nan || next.nan,
        }
    }

    pub(super) fn is_finite(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    pub(super) fn each(self, of: impl Fn(f64) -> f64) -> Bounds {
        Bounds { low: of(self.low), high: of(self.high), ..self }
    }

    /// Returns the bounds of the smaller of two numbers; a NaN is ignored.
    pub(super) fn smaller(self, other: Bounds) -> Bounds {
        let (a, b) = (self, other);
        let alone = |one: Bounds, is: bool| if is { one.high } else { f64::NEG_INFINITY };
        let high = a.high.min(b.high).max(alone(a, b.nan)).max(alone(b, a.nan));
        Bounds { low: a.low.min(b.low), high, nan: a.nan && b.nan }
    }

    /// Returns the bounds of the larger of two numbers.
    pub(super) fn larger(self, other: Bounds) -> Bounds {
        self.opposite().smaller(other.opposite()).opposite()
    }

    pub(super) fn opposite(self) -> Bounds {
        Bounds { low: -self.high, high: -self.low, nan: self.nan }
    }
}
