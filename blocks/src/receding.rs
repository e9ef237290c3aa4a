//! Nonlinear predictive control by real-time iteration: one quadratic program in each period.
//!
//! The plan has the inputs u(0), u(1), … of a horizon and the states x(1), x(2), … behind them. A period makes the
//! law x(k+1) = f(x(k), u(k)) linear along the plan, solves for the best change of the inputs by
//! [`crate::quadratic`], and moves the plan by one period. So the plan comes nearer to the optimum from period to
//! period, while the work of each is the same. [`crate::riccati`] is for linear laws.

use bessemer::prelude::*;

use crate::quadratic::{ActiveSet, ActiveSetProgram, Outcome};

/// Cost and limits in each period of a horizon.
///
/// The cost is half of Σ eᵀQe + (u − u₀)ᵀR(u − u₀), where e is the difference of a state from its target, with P in the
/// place of Q for the last state. A limit may be infinite.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Horizon<T: Real, const X: usize, const U: usize, const Y: usize> {
    /// Q, positive semidefinite.
    pub state: SMatrix<T, X, X>,
    /// P, positive semidefinite.
    pub last: SMatrix<T, X, X>,
    /// R, positive definite.
    pub input: SMatrix<T, U, U>,
    /// u₀, the input without cost.
    pub rest: SVector<T, U>,
    /// Lower limits of the inputs.
    pub low: SVector<T, U>,
    /// Upper limits of the inputs.
    pub high: SVector<T, U>,
    /// C, for outputs y = C x with limits.
    pub outputs: SMatrix<T, Y, X>,
    /// Lower limits of the outputs.
    pub lowest: SVector<T, Y>,
    /// Upper limits of the outputs.
    pub highest: SVector<T, Y>,
    /// Largest violation of a limit that counts as none, above 0, in the unit of the limits.
    pub tolerance: T,
}

/// Input of a period.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Receding<T: Real, const U: usize> {
    /// The input, always within its limits.
    pub input: SVector<T, U>,
    /// Result of the solver; unless it is `Solved`, the plan may leave the limits of the outputs.
    pub outcome: Outcome,
    /// Largest violation of a limit by the linear law.
    pub violation: T,
}

/// Nonlinear predictive control of `X` states, `U` inputs and `Y` outputs with limits, over `H` periods.
///
/// `N` is `U` × `H`, the inputs of the horizon, and `M` is `N` + `Y` × `H`. With the Jacobians A(k), B(k) of the law along
/// the plan, and the gap d(k) = f(x(k), u(k)) − x(k+1) of its states, the change of the plan is Δx(k+1) = A(k) Δx(k) +
/// B(k) Δu(k) + d(k). The states are eliminated, and an [`ActiveSet`] of `I` changes finds the Δu of least cost within
/// the limits. It is the full step of Gauss and Newton, without a search along it. Of a program without a solution, and
/// of numbers that are not finite, the plan takes nothing. Initialisation: [`RealTimeIteration::begin`]; `Default`
/// plans to stay at 0. Source: Diehl, Bock and Schlöder, *A Real-Time Iteration Scheme for Nonlinear Optimization in
/// Optimal Feedback Control*, SIAM Journal on Control and Optimization 43 (5), 2005.
///
/// ```
/// use bessemer::nalgebra::{Matrix1, SVector, Vector1};
/// use bessemer_blocks::{Horizon, Outcome, RealTimeIteration};
///
/// // A tank's level x, with x' = u - sqrt(x), filled from 1 to 4 by at most 3.
/// let one = Matrix1::new(1.0);
/// let horizon = Horizon {
///     state: one, last: one, input: one * 1e-3, rest: Vector1::new(2.0),
///     low: Vector1::new(0.0), high: Vector1::new(3.0),
///     outputs: one, lowest: Vector1::new(0.5), highest: Vector1::new(4.2), tolerance: 1e-9,
/// };
/// let law = |x: &Vector1<f64>, u: &Vector1<f64>| {
///     let root = x[0].sqrt();
///     (x + (u - Vector1::new(root)) * 0.1, Matrix1::new(1.0 - 0.05 / root), Matrix1::new(0.1))
/// };
/// let mut control = RealTimeIteration::<f64, 1, 1, 1, 10, 10, 20, 20>::default();
/// let mut level = Vector1::new(1.0);
/// control.begin(&level, &Vector1::new(1.0));
/// for _ in 0..40 {
///     let found = control.step(&horizon, &level, &[Vector1::new(4.0); 10], law);
///     assert_eq!(found.outcome, Outcome::Solved);
///     level = law(&level, &found.input).0;
/// }
/// assert!((level[0] - 4.0).abs() < 1e-3);
/// ```
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct RealTimeIteration<
    T: Real,
    const X: usize,
    const U: usize,
    const Y: usize,
    const H: usize,
    const N: usize,
    const M: usize,
    const I: usize,
> {
    /// The inputs u(0), u(1), ….
    inputs: [SVector<T, U>; H],
    /// The states x(1), x(2), ….
    states: [SVector<T, X>; H],
    /// Solver of the changes.
    solver: ActiveSet<T, N, M, I>,
}

impl<
    T: Real,
    const X: usize,
    const U: usize,
    const Y: usize,
    const H: usize,
    const N: usize,
    const M: usize,
    const I: usize,
> Default for RealTimeIteration<T, X, U, Y, H, N, M, I>
{
    fn default() -> Self {
        RealTimeIteration {
            inputs: [SVector::zeros(); H],
            states: [SVector::zeros(); H],
            solver: ActiveSet::default(),
        }
    }
}

#[component]
impl<
    T: Real,
    const X: usize,
    const U: usize,
    const Y: usize,
    const H: usize,
    const N: usize,
    const M: usize,
    const I: usize,
> RealTimeIteration<T, X, U, Y, H, N, M, I>
{
    /// Plans to stay at a state with an input.
    #[entry(infallible)]
    pub fn begin(&mut self, state: &SVector<T, X>, input: &SVector<T, U>) {
        for k in 0..H {
            self.inputs[k] = *input;
            self.states[k] = *state;
        }
    }

    /// Improves the plan from the measured state, returns its first input, and moves it by one period.
    ///
    /// `targets` are those of x(1), x(2), …. `law` gives the state after a period, and its Jacobians by the state and by
    /// the input: a `#[function(derivative(…))]`.
    pub fn step(
        &mut self,
        horizon: &Horizon<T, X, U, Y>,
        measured: &SVector<T, X>,
        targets: &[SVector<T, X>; H],
        law: impl Fn(
            &SVector<T, X>,
            &SVector<T, U>,
        ) -> (SVector<T, X>, SMatrix<T, X, X>, SMatrix<T, X, U>),
    ) -> Receding<T, U> {
        let found = self.improve(horizon, measured, targets, law);
        for k in 1..H {
            self.inputs[k - 1] = self.inputs[k];
            self.states[k - 1] = self.states[k];
        }
        found
    }

    /// Improves the plan from the measured state as `step` does, and does not move it: repeated, it converges.
    pub fn improve(
        &mut self,
        horizon: &Horizon<T, X, U, Y>,
        measured: &SVector<T, X>,
        targets: &[SVector<T, X>; H],
        law: impl Fn(
            &SVector<T, X>,
            &SVector<T, U>,
        ) -> (SVector<T, X>, SMatrix<T, X, X>, SMatrix<T, X, U>),
    ) -> Receding<T, U> {
        let mut hessian = SMatrix::<T, N, N>::zeros();
        let mut gradient = SVector::<T, N>::zeros();
        let mut rows = SMatrix::<T, M, N>::zeros();
        let mut low = SVector::<T, M>::zeros();
        let mut high = SVector::<T, M>::zeros();
        // The change of a state is `free` + `forced` Δu.
        let mut free = SVector::<T, X>::zeros();
        let mut forced = SMatrix::<T, X, N>::zeros();
        let mut changes = [free; H];
        let mut by_input = [forced; H];
        let mut state = *measured;
        for k in 0..H {
            let (next, by_state, by_own) = law(&state, &self.inputs[k]);
            forced = by_state * forced;
            for j in 0..U {
                let at = (k * U + j).min(N - 1);
                for i in 0..X {
                    forced[(i, at)] = by_own[(i, j)];
                }
            }
            free = by_state * free + (next - self.states[k]);
            changes[k] = free;
            by_input[k] = forced;
            state = self.states[k];

            let planned = state + free;
            let weight = if k + 1 == H { horizon.last } else { horizon.state };
            let weighted = weight * forced;
            hessian += forced.tr_mul(&weighted);
            gradient += weighted.tr_mul(&(planned - targets[k]));
            let cost = horizon.input * (self.inputs[k] - horizon.rest);
            for j in 0..U {
                let at = (k * U + j).min(N - 1);
                for i in 0..U {
                    hessian[((k * U + i).min(N - 1), at)] += horizon.input[(i, j)];
                }
                gradient[at] += cost[j];
                let row = at.min(M - 1);
                rows[(row, at)] = T::ONE;
                low[row] = horizon.low[j] - self.inputs[k][j];
                high[row] = horizon.high[j] - self.inputs[k][j];
            }
            let seen = horizon.outputs * planned;
            let caused = horizon.outputs * forced;
            for i in 0..Y {
                let row = (N + k * Y + i).min(M - 1);
                for at in 0..N {
                    rows[(row, at)] = caused[(i, at)];
                }
                low[row] = horizon.lowest[i] - seen[i];
                high[row] = horizon.highest[i] - seen[i];
            }
        }

        let mut outcome = Outcome::Unfinished;
        let mut violation = T::ZERO;
        if let Some(program) = ActiveSetProgram::new(&hessian, &rows, horizon.tolerance) {
            let found = self.solver.step(&program, &gradient, &low, &high);
            outcome = found.outcome;
            violation = found.violation;
            if outcome != Outcome::Infeasible && found.point.norm_squared().is_finite() {
                for k in 0..H {
                    self.states[k] += changes[k] + by_input[k] * found.point;
                    for j in 0..U {
                        self.inputs[k][j] += found.point[(k * U + j).min(N - 1)];
                    }
                }
            }
        }
        let input = self.inputs[0].sup(&horizon.low).inf(&horizon.high);
        Receding { input, outcome, violation }
    }
}
