//! Quadratic programs by the alternating direction method of multipliers, also with second-order cones.
//!
//! [`crate::quadratic`] says what the programs are.

use bessemer::prelude::*;

use crate::quadratic::{Minimum, Outcome};

/// Constant part of a program for [`Admm`], of `N` variables and `M` rows.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct AdmmProgram<T: Real, const N: usize, const M: usize> {
    /// The inverse of H + AᵀWA, with the weights in the diagonal of W.
    pub inverse: SMatrix<T, N, N>,
    /// A.
    pub rows: SMatrix<T, M, N>,
    /// Weight of each row, above 0; the rows of a cone have one weight.
    pub weights: SVector<T, M>,
    /// Residual that counts as none, above 0.
    pub tolerance: T,
}

#[data]
impl<T: Real, const N: usize, const M: usize> AdmmProgram<T, N, M> {
    /// Prepares a program; `None` unless H + AᵀWA is positive definite. Large weights favour the limits, small ones the
    /// minimum: about the size of H for rows of size 1, and a thousand times that for equations.
    pub fn new(
        hessian: &SMatrix<T, N, N>,
        rows: &SMatrix<T, M, N>,
        weights: &SVector<T, M>,
        tolerance: T,
    ) -> Option<Self> {
        let mut weighted = *rows;
        for i in 0..M {
            for k in 0..N {
                weighted[(i, k)] *= weights[i];
            }
        }
        let inverse = (hessian + rows.tr_mul(&weighted)).cholesky()?.inverse();
        Some(AdmmProgram { inverse, rows: *rows, weights: *weights, tolerance })
    }
}

/// Solver by `I` iterations of the alternating direction method of multipliers, each the same work; H may be
/// semidefinite. The last `C` × `D` rows are `C` second-order cones of `D` rows, the others have limits.
///
/// A cone holds where the first of its rows, less its lower limit, is at least the length of the others, less theirs.
/// An iteration minimises with the rows near their last values, z = (H + AᵀWA)⁻¹(Aᵀ(Ws − y) − g), relaxes, r = 1.6 Az −
/// 0.6 s, and projects, s = Π(r + W⁻¹y), y += W(r − s). The tolerance is for Az − s and for the gradient. A problem
/// is infeasible if the last change of y proves it, to one in a thousand. Initialisation: `Default` begins at 0.
/// Source: Stellato et al., *OSQP: an operator splitting solver for quadratic programs*, Mathematical Programming
/// Computation 12, 2020.
///
/// ```
/// use bessemer::nalgebra::{Matrix3, SVector, Vector3};
/// use bessemer_blocks::{Admm, AdmmProgram, Outcome};
///
/// // The nearest point to (0, 3, 4) in the cone of the first axis.
/// let one = Matrix3::identity();
/// let program = AdmmProgram::new(&one, &one, &Vector3::repeat(1.0), 1e-9).unwrap();
/// let mut solver = Admm::<f64, 3, 3, 1, 3, 60>::default();
/// let zero = SVector::zeros();
/// let found = solver.step(&program, &-Vector3::new(0.0, 3.0, 4.0), &zero, &zero);
/// assert_eq!(found.outcome, Outcome::Solved);
/// assert!((found.point - Vector3::new(2.5, 1.5, 2.0)).norm() < 1e-8);
/// ```
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Admm<
    T: Real,
    const N: usize,
    const M: usize,
    const C: usize,
    const D: usize,
    const I: usize,
> {
    /// The rows s, within their limits.
    values: SVector<T, M>,
    /// The multipliers y.
    multipliers: SVector<T, M>,
}

impl<T: Real, const N: usize, const M: usize, const C: usize, const D: usize, const I: usize>
    Default for Admm<T, N, M, C, D, I>
{
    fn default() -> Self {
        Admm { values: SVector::zeros(), multipliers: SVector::zeros() }
    }
}

#[component]
impl<T: Real, const N: usize, const M: usize, const C: usize, const D: usize, const I: usize>
    Admm<T, N, M, C, D, I>
{
    /// Solves a program with gradient g and these limits; equal ones are an equation.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        program: &AdmmProgram<T, N, M>,
        gradient: &SVector<T, N>,
        low: &SVector<T, M>,
        high: &SVector<T, M>,
    ) -> Minimum<T, N> {
        let mut point = SVector::<T, N>::zeros();
        let mut change = SVector::<T, M>::zeros();
        let mut gap = SVector::<T, M>::zeros();
        let mut slope = SVector::<T, M>::zeros();
        for _ in 0..I {
            let pull = self.values.component_mul(&program.weights) - self.multipliers;
            point = program.inverse * (program.rows.tr_mul(&pull) - gradient);
            let reached = program.rows * point;
            let relaxed = reached * real::<T>(1.6) - self.values * real::<T>(0.6);
            let mut values = relaxed + self.multipliers.component_div(&program.weights);
            project::<T, M, C, D>(&mut values, low, high);
            change = (relaxed - values).component_mul(&program.weights);
            slope = change - (reached - self.values).component_mul(&program.weights);
            gap = reached - values;
            self.values = values;
            self.multipliers += change;
        }
        let violation = gap.amax();
        let is_finite = point.norm_squared().is_finite();
        let is_empty = self.proves(program, &change, low, high);
        let outcome = if is_finite
            && !is_empty
            && violation <= program.tolerance
            && program.rows.tr_mul(&slope).amax() <= program.tolerance
        {
            Outcome::Solved
        } else if is_empty {
            Outcome::Infeasible
        } else {
            Outcome::Unfinished
        };
        if is_empty || !is_finite || !self.multipliers.norm_squared().is_finite() {
            self.values = SVector::zeros();
            self.multipliers = SVector::zeros();
        }
        Minimum { point, outcome, violation }
    }

    /// Returns true if limits exclude each other, or a change of the multipliers separates them from every Az.
    fn proves(
        &self,
        program: &AdmmProgram<T, N, M>,
        change: &SVector<T, M>,
        low: &SVector<T, M>,
        high: &SVector<T, M>,
    ) -> bool {
        for i in 0..(M as u32).saturating_sub((C * D) as u32) as usize {
            if low[i] > high[i] {
                return true;
            }
        }
        let small = change.amax() * real(1e-3);
        let most = support::<T, M, C, D>(change, low, high, small);
        most < -small && program.rows.tr_mul(change).amax() <= small
    }
}

/// Returns the most of `direction`ᵀs for rows s within their limits and cones: infinite if they do not bound it, to
/// `small`.
#[function]
pub(crate) fn support<T: Real, const M: usize, const C: usize, const D: usize>(
    direction: &SVector<T, M>,
    low: &SVector<T, M>,
    high: &SVector<T, M>,
    small: T,
) -> T {
    let cones = (M as u32).saturating_sub((C * D) as u32);
    let mut most = T::ZERO;
    for i in 0..cones as usize {
        let limit = if direction[i] > T::ZERO { high[i] } else { low[i] };
        // Small directions at no limit are rounding errors.
        if limit.is_finite() || direction[i].abs() > small {
            most += limit * direction[i];
        }
    }
    for c in 0..C as u32 {
        let first = row::<M>(cones, c * D as u32);
        let mut square = T::ZERO;
        for d in 0..D as u32 {
            let at = row::<M>(first as u32, d);
            most += low[at] * direction[at];
            if d > 0 {
                square += direction[at] * direction[at];
            }
        }
        if !(square.sqrt() <= small - direction[first]) {
            most = T::INFINITY;
        }
    }
    most
}

/// Replaces rows by the nearest ones within their limits and cones.
#[function]
pub(crate) fn project<T: Real, const M: usize, const C: usize, const D: usize>(
    rows: &mut SVector<T, M>,
    low: &SVector<T, M>,
    high: &SVector<T, M>,
) {
    let cones = (M as u32).saturating_sub((C * D) as u32);
    for i in 0..cones as usize {
        rows[i] = rows[i].max(low[i]).min(high[i]);
    }
    for c in 0..C as u32 {
        let first = row::<M>(cones, c * D as u32);
        let axis = rows[first] - low[first];
        let mut square = T::ZERO;
        for d in 1..D as u32 {
            let at = row::<M>(first as u32, d);
            square += (rows[at] - low[at]) * (rows[at] - low[at]);
        }
        let length = square.sqrt();
        let (height, share) = if length <= axis {
            (axis, T::ONE)
        } else if length <= -axis {
            (T::ZERO, T::ZERO)
        } else {
            let height = (axis + length) * real(0.5);
            (height, height / length)
        };
        rows[first] = low[first] + height;
        for d in 1..D as u32 {
            let at = row::<M>(first as u32, d);
            rows[at] = low[at] + (rows[at] - low[at]) * share;
        }
    }
}

/// Returns the index of a row behind another, and the last row if there are fewer: a program without cones has none to
/// index.
#[function]
fn row<const M: usize>(from: u32, behind: u32) -> usize {
    from.saturating_add(behind).min(M as u32 - 1) as usize
}
