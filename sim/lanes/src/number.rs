//! A number, or a number of each lane: for formulas that are written once and computed both ways.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::Real;

/// A number with the four operations: `f64`, or [`Real`] for eight runs at once.
///
/// ```
/// use bessemer_lanes::{Number, Real};
///
/// fn energy<T: Number>(mass: T, speed: T) -> T {
///     T::of(0.5) * mass * speed * speed
/// }
///
/// assert_eq!(energy(2.0, 3.0), 9.0);
/// assert_eq!(energy(Real::of(2.0), Real::of(3.0)).lane(7), 9.0);
/// ```
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Returns a number, in each lane.
    fn of(value: f64) -> Self;

    /// Returns the magnitude.
    #[must_use]
    fn magnitude(self) -> Self;

    /// Returns `then` where the number is below another, and `otherwise` elsewhere, also beside a NaN.
    #[must_use]
    fn below(self, other: Self, then: Self, otherwise: Self) -> Self;
}

impl Number for f64 {
    fn of(value: f64) -> f64 {
        value
    }

    fn magnitude(self) -> f64 {
        self.abs()
    }

    #[inline(always)]
    fn below(self, other: f64, then: f64, otherwise: f64) -> f64 {
        if self < other { then } else { otherwise }
    }
}

impl Number for Real {
    #[inline(always)]
    fn of(value: f64) -> Real {
        Real::of(value)
    }

    #[inline(always)]
    fn magnitude(self) -> Real {
        self.abs()
    }

    #[inline(always)]
    fn below(self, other: Real, then: Real, otherwise: Real) -> Real {
        then.or(self.lt(other), otherwise)
    }
}
