//! Tables with one and two inputs: linear between the points, and beyond the ends as the caller chooses.
//!
//! Axes ascend strictly and have at least two points; a test of the model can check them with [`ascends`]. An input
//! that is NaN gives the first value. With [`Beyond::Hold`] each result is between the neighbouring values, up to
//! rounding.
//!
//! Source: linear interpolation, f = f₀ + s (f₁ − f₀) with s = (x − x₀)/(x₁ − x₀). With two inputs it
//! interpolates along the columns first.

use bessemer::prelude::*;
use num_traits::AsPrimitive;

/// Values beyond the ends of an axis.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Beyond {
    /// The value of the end.
    #[default]
    Hold,
    /// The line through the two points at the end, extended.
    Extend,
}

/// Position on an axis, between the points `below` and `below + 1`.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place<T> {
    /// Index of the lower point.
    pub below: u32,
    /// Fraction of the distance: 0 at the lower point, 1 at the upper one; less or more beyond the ends.
    pub share: T,
}

/// Returns true if an axis ascends strictly, as all tables require.
///
/// ```
/// assert!(bessemer_blocks::ascends(&[0.0, 1.0, 4.0]) && !bessemer_blocks::ascends(&[0.0, 0.0]));
/// ```
#[function]
pub fn ascends<T: Real, const N: usize>(axis: &[T; N]) -> bool {
    let mut ascends = true;
    for k in 1..N {
        ascends &= axis[k] > axis[k - 1];
    }
    ascends
}

/// Axis of `N` points with equal spacing: a position in constant time.
///
/// ```
/// use bessemer_blocks::{Beyond, UniformAxis, interpolated};
///
/// let axis = UniformAxis::<f32, 3> { first: 10.0, spacing: 5.0 };
/// let table = [0.0, 1.0, 4.0];
/// assert_eq!(interpolated(&table, axis.place(17.5, Beyond::Hold)), 2.5);
/// assert_eq!(interpolated(&table, axis.place(25.0, Beyond::Hold)), 4.0);
/// assert_eq!(interpolated(&table, axis.place(25.0, Beyond::Extend)), 7.0);
/// ```
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UniformAxis<T, const N: usize> {
    /// The first point.
    pub first: T,
    /// Distance of the points, above 0.
    pub spacing: T,
}

#[data]
impl<T: Real + AsPrimitive<u32>, const N: usize> UniformAxis<T, N> {
    /// Returns the position of a value.
    pub fn place(&self, value: T, beyond: Beyond) -> Place<T> {
        let at = (value - self.first) / self.spacing;
        let whole = at.max(T::ZERO).min(real::<T>(N as f64) - real(2.0)).floor();
        let below: u32 = whole.as_();
        Place { below: below.min(N as u32 - 2), share: limited(at - whole, beyond) }
    }
}

/// Axis of `N` points at any distances: a position by search.
///
/// ```
/// use bessemer_blocks::{Axis, Beyond, interpolated};
///
/// const AXIS: Axis<f64, 4> = Axis { points: [0.0, 1.0, 4.0, 9.0] };
/// assert_eq!(interpolated(&[0.0, 1.0, 2.0, 3.0], AXIS.place(2.5, Beyond::Hold)), 1.5);
/// ```
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis<T, const N: usize> {
    /// The points, strictly ascending.
    pub points: [T; N],
}

#[data]
impl<T: Real, const N: usize> Axis<T, N> {
    /// Returns the position of a value. The search takes as many steps as there are points below.
    pub fn place(&self, value: T, beyond: Beyond) -> Place<T> {
        let mut below = 0;
        for k in 1..N as u32 - 1 {
            if value >= self.points[k as usize] {
                below = k;
            } else {
                break;
            }
        }
        self.between(below, value, beyond)
    }

    /// Returns the position of a value from the point below it.
    fn between(&self, below: u32, value: T, beyond: Beyond) -> Place<T> {
        let below = below.min(N as u32 - 2);
        let (low, high) = (self.points[below as usize], self.points[(below + 1) as usize]);
        Place { below, share: limited((value - low) / (high - low), beyond) }
    }
}

/// Search with memory: it begins where the last one ended, so that a value that moves little takes few steps.
///
/// Initialisation: `Default` begins at the first point. The results equal those of [`Axis::place`].
///
/// ```
/// use bessemer_blocks::{Axis, Beyond, Search};
///
/// const AXIS: Axis<f64, 4> = Axis { points: [0.0, 1.0, 4.0, 9.0] };
/// let mut search = Search::default();
/// assert_eq!([5.0, 4.5, 0.5].map(|value| search.place(&AXIS, value, Beyond::Hold).below), [2, 2, 0]);
/// ```
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Search {
    /// The point below the last value.
    below: u32,
}

#[component]
impl Search {
    /// Returns the position of a value.
    pub fn place<T: Real, const N: usize>(
        &mut self,
        axis: &Axis<T, N>,
        value: T,
        beyond: Beyond,
    ) -> Place<T> {
        let mut below = self.below;
        for _ in 1..N {
            let here = below.min(N as u32 - 2);
            if here < N as u32 - 2 && value >= axis.points[(here + 1) as usize] {
                below = here + 1;
            } else if here > 0 && value < axis.points[here as usize] {
                below = here - 1;
            } else {
                break;
            }
        }
        self.below = below;
        axis.between(below, value, beyond)
    }
}

/// Value of a table at a position of its axis.
#[function]
pub fn interpolated<T: Real, const N: usize>(values: &[T; N], place: Place<T>) -> T {
    let below = place.below.min(N as u32 - 2);
    let (low, high) = (values[below as usize], values[(below + 1) as usize]);
    low + place.share * (high - low)
}

/// Value of a table with `R` rows and `C` columns at the positions of its two axes.
///
/// ```
/// use bessemer_blocks::{Axis, Beyond, interpolated_2d};
///
/// const SPEEDS: Axis<f64, 2> = Axis { points: [0.0, 10.0] };
/// const LOADS: Axis<f64, 3> = Axis { points: [0.0, 0.5, 1.0] };
/// let table = [[0.0, 1.0, 2.0], [10.0, 21.0, 32.0]];
/// let (row, column) = (SPEEDS.place(5.0, Beyond::Hold), LOADS.place(0.75, Beyond::Hold));
/// assert_eq!(interpolated_2d(&table, row, column), 14.0);
/// ```
#[function]
pub fn interpolated_2d<T: Real, const R: usize, const C: usize>(
    values: &[[T; C]; R],
    row: Place<T>,
    column: Place<T>,
) -> T {
    let below = row.below.min(R as u32 - 2);
    let low = interpolated(&values[below as usize], column);
    let high = interpolated(&values[(below + 1) as usize], column);
    low + row.share * (high - low)
}

/// Limits the fraction of a position; NaN becomes 0.
#[function]
fn limited<T: Real>(share: T, beyond: Beyond) -> T {
    match beyond {
        Beyond::Hold => share.max(T::ZERO).min(T::ONE),
        Beyond::Extend => {
            if share.is_nan() {
                T::ZERO
            } else {
                share
            }
        }
    }
}
