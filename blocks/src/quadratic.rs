//! Quadratic programs of fixed size: the minimum of zᵀHz/2 + gᵀz with low ≤ Az ≤ high.
//!
//! A model predictive control solves one in each period: z has the inputs of the horizon, g and the limits follow from
//! the measured state (`bessemer_design::condensed`). Both solvers take a fixed largest number of iterations, begin at
//! the last solution, and report a problem without any solution. The active set is here, and gives the minimum to
//! rounding errors after few iterations; [`crate::admm`] also takes cones, and each of its iterations is the same work.

use bessemer::prelude::*;

/// Result of a solver.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Outcome {
    /// The point is the minimum, to the tolerance.
    Solved,
    /// The iterations were too few; the point is the best so far.
    #[default]
    Unfinished,
    /// No point is within the limits. The next call begins anew, as it does after numbers that are not finite.
    Infeasible,
}

/// Point that a solver found.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Minimum<T: Real, const N: usize> {
    /// The point z.
    pub point: SVector<T, N>,
    /// Result of the solver.
    pub outcome: Outcome,
    /// Largest distance of a row of Az from its limits or its cone.
    pub violation: T,
}

/// Constant part of a program for an [`ActiveSet`], of `N` variables and `M` rows.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct ActiveSetProgram<T: Real, const N: usize, const M: usize> {
    /// L⁻ᵀ, with H = LLᵀ.
    pub inverse: SMatrix<T, N, N>,
    /// A L⁻ᵀ.
    pub rows: SMatrix<T, M, N>,
    /// Largest violation of a limit that counts as none, above 0, in the unit of the limits.
    pub tolerance: T,
}

#[data]
impl<T: Real, const N: usize, const M: usize> ActiveSetProgram<T, N, M> {
    /// Prepares a program; `None` unless H, `hessian`, is positive definite.
    pub fn new(hessian: &SMatrix<T, N, N>, rows: &SMatrix<T, M, N>, tolerance: T) -> Option<Self> {
        let lower = hessian.cholesky()?.l();
        let mut inverse = SMatrix::<T, N, N>::identity();
        for column in 0..N {
            for i in column..N {
                let mut sum = inverse[(column, i)];
                for k in column..i {
                    sum -= lower[(i, k)] * inverse[(column, k)];
                }
                inverse[(column, i)] = sum / lower[(i, i)];
            }
        }
        Some(ActiveSetProgram { inverse, rows: rows * inverse, tolerance })
    }
}

/// A row by the working rows before it.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach<T: Real, const N: usize> {
    /// The row of L.
    lower: SVector<T, N>,
    /// The square of its length.
    size: T,
    /// The pivot: the square of the part that the rows before do not reach.
    pivot: T,
}

/// Rows of A L⁻ᵀ with an active limit, each with a sign: 1 at the upper limit, −1 at the lower one.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkingSet<T: Real, const N: usize> {
    /// Number of rows.
    count: u32,
    /// Their indices.
    rows: [u32; N],
    /// Their signs.
    signs: SVector<T, N>,
    /// Their multipliers, 0 or more; of an equation any number.
    multipliers: SVector<T, N>,
    /// L below its diagonal of ones, with LDLᵀ the products of the signed rows with each other.
    lower: SMatrix<T, N, N>,
    /// D.
    pivots: SVector<T, N>,
}

#[data]
impl<T: Real, const N: usize> WorkingSet<T, N> {
    /// Returns the index of a working row.
    fn row<const M: usize>(&self, at: usize) -> usize {
        if at < N { (self.rows[at] as usize).min(M - 1) } else { 0 }
    }

    /// Expresses a signed row by the first `count` working rows.
    fn reach<const M: usize>(
        &self,
        rows: &SMatrix<T, M, N>,
        count: usize,
        row: usize,
        sign: T,
    ) -> Reach<T, N> {
        let row = row.min(M - 1);
        let mut lower = SVector::<T, N>::zeros();
        let mut size = T::ZERO;
        for k in 0..N {
            size += rows[(row, k)] * rows[(row, k)];
        }
        let mut pivot = size;
        for i in 0..count.min(N) {
            let other = self.row::<M>(i);
            let mut product = T::ZERO;
            for k in 0..N {
                product += rows[(other, k)] * rows[(row, k)];
            }
            product *= self.signs[i] * sign;
            for k in 0..i {
                product -= self.lower[(i, k)] * lower[k];
            }
            lower[i] = product;
        }
        for i in 0..count.min(N) {
            let product = lower[i];
            lower[i] = product / self.pivots[i];
            pivot -= product * lower[i];
        }
        Reach { lower, size, pivot }
    }

    /// Stores a row behind `count` others.
    fn store(&mut self, count: usize, row: usize, sign: T, reach: &Reach<T, N>) {
        if count < N {
            self.rows[count] = row as u32;
            self.signs[count] = sign;
            for k in 0..count {
                self.lower[(count, k)] = reach.lower[k];
            }
            self.pivots[count] = reach.pivot;
        }
    }

    /// Begins with other limits: what was an equation may have had any multiplier.
    fn begin<const M: usize>(&mut self, rows: &SMatrix<T, M, N>) {
        for i in 0..(self.count as usize).min(N) {
            if self.multipliers[i] < T::ZERO {
                self.multipliers[i] = -self.multipliers[i];
                self.signs[i] = -self.signs[i];
            }
        }
        self.factor(rows, 0);
    }

    /// Factors the rows from `from` on again.
    fn factor<const M: usize>(&mut self, rows: &SMatrix<T, M, N>, from: usize) {
        for at in from..(self.count as usize).min(N) {
            let (row, sign) = (self.row::<M>(at), self.signs[at]);
            let reach = self.reach(rows, at, row, sign);
            self.store(at, row, sign, &reach);
        }
    }

    /// Removes a row.
    fn remove<const M: usize>(&mut self, rows: &SMatrix<T, M, N>, leaving: usize) {
        for at in 1..(self.count as usize).min(N) {
            if at > leaving {
                self.rows[at - 1] = self.rows[at];
                self.signs[at - 1] = self.signs[at];
                self.multipliers[at - 1] = self.multipliers[at];
            }
        }
        self.count = self.count.saturating_sub(1);
        self.factor(rows, leaving);
    }

    /// Returns x with Lᵀx = b.
    fn solve_transposed(&self, b: &SVector<T, N>) -> SVector<T, N> {
        let count = (self.count as usize).min(N);
        let mut x = *b;
        for i in (0..count).rev() {
            let mut sum = x[i];
            for k in i + 1..count {
                sum -= self.lower[(k, i)] * x[k];
            }
            x[i] = sum;
        }
        x
    }

    /// Returns the multipliers with which each active limit is an equation: LDLᵀx = −limits.
    fn equations<const M: usize>(
        &self,
        low: &SVector<T, M>,
        high: &SVector<T, M>,
    ) -> SVector<T, N> {
        let count = (self.count as usize).min(N);
        let mut x = SVector::<T, N>::zeros();
        for i in 0..count {
            let row = self.row::<M>(i);
            let mut sum = if self.signs[i] > T::ZERO { -high[row] } else { low[row] };
            for k in 0..i {
                sum -= self.lower[(i, k)] * x[k];
            }
            x[i] = sum;
        }
        for i in 0..count {
            x[i] /= self.pivots[i];
        }
        self.solve_transposed(&x)
    }

    /// Returns the first row whose multiplier falls to zero along `direction`, and the share of it until then. Without
    /// such a row the result is `N` and `most`. Equations stay, and so do rows that move by no more than `small`.
    fn first_leaving<const M: usize>(
        &self,
        direction: &SVector<T, N>,
        most: T,
        small: T,
        low: &SVector<T, M>,
        high: &SVector<T, M>,
    ) -> (usize, T) {
        let (mut leaving, mut share) = (N, most);
        for i in 0..(self.count as usize).min(N) {
            let row = self.row::<M>(i);
            if direction[i] < -small && low[row] < high[row] {
                let own = -self.multipliers[i] / direction[i];
                if own < share {
                    share = own;
                    leaving = i;
                }
            }
        }
        (leaving, share)
    }

    /// Moves the multipliers by a share of a direction.
    fn advance(&mut self, direction: &SVector<T, N>, share: T) {
        for i in 0..(self.count as usize).min(N) {
            self.multipliers[i] += direction[i] * share;
        }
    }

    /// Returns the minimum for the multipliers.
    fn minimum<const M: usize>(&self, rows: &SMatrix<T, M, N>) -> SVector<T, N> {
        let mut point = SVector::<T, N>::zeros();
        for i in 0..(self.count as usize).min(N) {
            let row = self.row::<M>(i);
            let weight = self.multipliers[i] * self.signs[i];
            for k in 0..N {
                point[k] -= rows[(row, k)] * weight;
            }
        }
        point
    }
}

/// Dual active-set solver, for at most `I` changes of the set of active limits; `M` is at least 1.
///
/// It solves for the multipliers with the active limits as equations. A row whose multiplier would become negative
/// leaves; else the row with the largest violation enters. Initialisation: `Default` begins without active limits. A
/// limit may be infinite. Rounding errors grow with the condition of H, whose Cholesky factor scales the rows. Source:
/// Arnström, Bemporad and Axehill, *A Dual Active-Set Solver for Embedded Quadratic Programming Using Recursive LDLᵀ
/// Updates*, IEEE Transactions on Automatic Control 67 (8), 2022.
///
/// ```
/// use bessemer::nalgebra::{Matrix2, Vector2};
/// use bessemer_blocks::{ActiveSet, ActiveSetProgram, Outcome};
///
/// // The nearest point to (2, 1) in a box.
/// let program = ActiveSetProgram::new(&Matrix2::identity(), &Matrix2::identity(), 1e-9).unwrap();
/// let mut solver = ActiveSet::<f64, 2, 2, 10>::default();
/// let most = Vector2::new(0.5, 0.5);
/// let found = solver.step(&program, &Vector2::new(-2.0, -1.0), &-most, &most);
/// assert_eq!((found.outcome, found.point), (Outcome::Solved, most));
/// ```
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct ActiveSet<T: Real, const N: usize, const M: usize, const I: usize> {
    /// The active limits.
    working: WorkingSet<T, N>,
}

impl<T: Real, const N: usize, const M: usize, const I: usize> Default for ActiveSet<T, N, M, I> {
    fn default() -> Self {
        let zeros = SVector::zeros();
        ActiveSet {
            working: WorkingSet {
                count: 0,
                rows: [0; N],
                signs: zeros,
                multipliers: zeros,
                lower: SMatrix::zeros(),
                pivots: zeros,
            },
        }
    }
}

#[component]
impl<T: Real, const N: usize, const M: usize, const I: usize> ActiveSet<T, N, M, I> {
    /// Solves a program with gradient g and these limits; equal ones are an equation.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        program: &ActiveSetProgram<T, N, M>,
        gradient: &SVector<T, N>,
        low: &SVector<T, M>,
        high: &SVector<T, M>,
    ) -> Minimum<T, N> {
        let offset = program.inverse.tr_mul(gradient);
        let shift = program.rows * offset;
        let (low, high) = (low + shift, high + shift);
        self.working.begin(&program.rows);
        let mut point = SVector::<T, N>::zeros();
        let (mut outcome, mut violation) = (Outcome::Unfinished, T::ZERO);
        for i in 0..M {
            if low[i] > high[i] {
                outcome = Outcome::Infeasible;
            }
        }
        for _ in 0..I {
            if outcome == Outcome::Infeasible {
                break;
            }
            let direction = self.working.equations(&low, &high) - self.working.multipliers;
            let (leaving, share) =
                self.working.first_leaving(&direction, T::ONE, T::ZERO, &low, &high);
            self.working.advance(&direction, share);
            if leaving < N {
                self.working.remove(&program.rows, leaving);
                continue;
            }
            point = self.working.minimum(&program.rows);
            let values = program.rows * point;
            let (mut row, mut sign) = (0, T::ONE);
            violation = T::ZERO;
            for i in 0..M {
                if values[i] - high[i] > violation {
                    (row, sign, violation) = (i, T::ONE, values[i] - high[i]);
                }
                if low[i] - values[i] > violation {
                    (row, sign, violation) = (i, -T::ONE, low[i] - values[i]);
                }
            }
            if violation <= program.tolerance {
                outcome = Outcome::Solved;
                break;
            }
            if !self.enter(program, row, sign, &low, &high) {
                outcome = Outcome::Infeasible;
            }
        }
        let point = program.inverse * (point - offset);
        let multipliers = self.working.multipliers.norm_squared();
        // NaN violates no limit.
        let is_finite = point.norm_squared().is_finite() && multipliers.is_finite();
        if outcome == Outcome::Solved && !is_finite {
            outcome = Outcome::Unfinished;
        }
        if outcome == Outcome::Infeasible || !is_finite {
            self.working.count = 0;
            self.working.multipliers = SVector::zeros();
        }
        Minimum { point, outcome, violation }
    }

    /// Makes a limit active; one that depends on the active ones replaces one of them. Returns false if none can leave.
    fn enter(
        &mut self,
        program: &ActiveSetProgram<T, N, M>,
        row: usize,
        sign: T,
        low: &SVector<T, M>,
        high: &SVector<T, M>,
    ) -> bool {
        let count = (self.working.count as usize).min(N);
        let mut reach = self.working.reach(&program.rows, count, row, sign);
        let mut multiplier = T::ZERO;
        if count == N || reach.pivot <= reach.size * T::EPSILON * real(1024.0) {
            let direction = self.working.solve_transposed(&-reach.lower);
            // A direction of rounding errors would exchange a row on which this one does not depend.
            let small = T::EPSILON * real(1024.0);
            let (leaving, share) =
                self.working.first_leaving(&direction, T::INFINITY, small, low, high);
            if leaving == N {
                return false;
            }
            self.working.advance(&direction, share);
            multiplier = share;
            self.working.remove(&program.rows, leaving);
            let count = (self.working.count as usize).min(N);
            reach = self.working.reach(&program.rows, count, row, sign);
        }
        let count = (self.working.count as usize).min(N - 1);
        self.working.multipliers[count] = multiplier;
        self.working.store(count, row, sign, &reach);
        self.working.count = count as u32 + 1;
        true
    }
}
