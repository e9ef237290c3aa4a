//! Intervals of integers: the lattice.
//!
//! An interval means the set of its integers. It is never empty; unreachable code is known by its statements, not by
//! its values. The order is inclusion; [`Interval::join`] is the least interval that contains both. Nothing here
//! depends on the width of a type, so each function can be tested on all values of a narrow one.

use bessemer_ir::Int;

/// All integers from `low` to `high`. `bool` is 0 or 1, an enum the index of its variant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Interval {
    pub(crate) low: i128,
    pub(crate) high: i128,
}

impl Interval {
    pub(crate) const BOOL: Interval = Interval { low: 0, high: 1 };

    /// Returns the interval between two bounds, in either order.
    pub(crate) fn new(a: i128, b: i128) -> Interval {
        Interval { low: a.min(b), high: a.max(b) }
    }

    pub(crate) fn one(value: i128) -> Interval {
        Interval { low: value, high: value }
    }

    pub(crate) fn of(int: Int) -> Interval {
        Interval { low: int.min(), high: int.max() }
    }

    pub(crate) fn contains(self, value: i128) -> bool {
        self.low <= value && value <= self.high
    }

    pub(crate) fn within(self, other: Interval) -> bool {
        other.low <= self.low && self.high <= other.high
    }

    pub(crate) fn single(self) -> Option<i128> {
        (self.low == self.high).then_some(self.low)
    }

    /// Returns the least interval that contains both.
    pub(crate) fn join(self, other: Interval) -> Interval {
        Interval { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Returns the intersection. If it is empty, the code is unreachable, and the result is the nearest bound of
    /// `self`. So more knowledge of operands never yields less knowledge of the result.
    pub(crate) fn meet(self, other: Interval) -> Interval {
        Interval {
            low: other.low.clamp(self.low, self.high),
            high: other.high.clamp(self.low, self.high),
        }
    }

    /// Returns the interval without a value that does not occur.
    pub(crate) fn without(self, value: i128) -> Interval {
        if self.low == self.high {
            self
        } else if value == self.low {
            Interval { low: self.low + 1, high: self.high }
        } else if value == self.high {
            Interval { low: self.low, high: self.high - 1 }
        } else {
            self
        }
    }
}

impl std::fmt::Display for Interval {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.single() {
            Some(value) => write!(f, "{value}"),
            None => write!(f, "{}..={}", self.low, self.high),
        }
    }
}
