//! Linear predictive control by the alternating direction method of multipliers on the Riccati recursion.
//!
//! The gains of the recursion are constants, so an iteration is products of small matrices and its work grows with the
//! number of periods, not with its cube. [`crate::quadratic`] is for fewer unknowns and outputs, and exact.

use bessemer::prelude::*;

use crate::admm::{project, support};
use crate::quadratic::Outcome;
use crate::receding::Receding;

/// Law, cost and limits of a [`RiccatiAdmm`], the same in each period.
///
/// The cost is half of Σ eᵀQe + uᵀRu, where e is the difference of a state from the target, with P − wI in the place of Q
/// for the last state. A limit may be infinite, save the first one of a cone.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct RiccatiProgram<T: Real, const X: usize, const U: usize> {
    /// A.
    pub by_state: SMatrix<T, X, X>,
    /// B.
    pub by_input: SMatrix<T, X, U>,
    /// Q.
    pub state: SMatrix<T, X, X>,
    /// w, the weight of the limits.
    pub weight: T,
    /// P.
    pub last: SMatrix<T, X, X>,
    /// K = (R + wI + BᵀPB)⁻¹BᵀPA.
    pub gain: SMatrix<T, U, X>,
    /// (R + wI + BᵀPB)⁻¹.
    pub inverse: SMatrix<T, U, U>,
    /// A − BK.
    pub closed: SMatrix<T, X, X>,
    /// Lower limits of the states.
    pub lowest: SVector<T, X>,
    /// Upper limits of the states.
    pub highest: SVector<T, X>,
    /// Lower limits of the inputs.
    pub low: SVector<T, U>,
    /// Upper limits of the inputs.
    pub high: SVector<T, U>,
    /// Residual that counts as none, above 0.
    pub tolerance: T,
}

#[data]
impl<T: Real, const X: usize, const U: usize> RiccatiProgram<T, X, U> {
    /// Prepares a program without limits; `None` unless R + wI + BᵀPB is positive definite. P is the solution of the
    /// Riccati equation with Q + wI and R + wI (`bessemer_design::dare`).
    pub fn new(
        (by_state, by_input): (&SMatrix<T, X, X>, &SMatrix<T, X, U>),
        (state, input): (&SMatrix<T, X, X>, &SMatrix<T, U, U>),
        last: &SMatrix<T, X, X>,
        weight: T,
        tolerance: T,
    ) -> Option<Self> {
        let carried = last * by_input;
        let mut sum = input + by_input.tr_mul(&carried);
        for i in 0..U {
            sum[(i, i)] += weight;
        }
        let inverse = sum.cholesky()?.inverse();
        let gain = inverse * carried.tr_mul(by_state);
        Some(RiccatiProgram {
            by_state: *by_state,
            by_input: *by_input,
            state: *state,
            weight,
            last: *last,
            gain,
            inverse,
            closed: by_state - by_input * gain,
            lowest: SVector::repeat(-T::INFINITY),
            highest: SVector::repeat(T::INFINITY),
            low: SVector::repeat(-T::INFINITY),
            high: SVector::repeat(T::INFINITY),
            tolerance,
        })
    }
}

/// Solver of `X` states, `U` inputs and `H` periods by `I` iterations, each the same work. The last `C` × `D` inputs of a
/// period are `C` second-order cones of `D` inputs; the others have limits, and so have the states.
///
/// A cone is defined in [`crate::admm`]. An iteration goes backwards by d(k) = (R + wI + BᵀPB)⁻¹(Bᵀp(k+1) + r(k)), p(k) = q(k) +
/// (A − BK)ᵀp(k+1) − Kᵀr(k), with r(k) = −w(z(k) − y(k)) and q(k) = −Qt − w(v(k) − g(k)), and forwards by u(k) = −Kx(k) −
/// d(k), x(k+1) = Ax(k) + Bu(k). It projects, z = Π(u + y) and v = Π(x + g), and adds up the remainders, y += u − z and
/// g += x − v. The tolerance is for u − z, x − v, and w times the changes of z and v. A problem is infeasible if the last
/// remainders prove it, to one in a thousand. Initialisation: `Default` begins at 0. Source: Nguyen, Schoedel, Alavilli,
/// Plancher and Manchester, *TinyMPC: Model-Predictive Control on Resource-Constrained Microcontrollers*, ICRA 2024.
///
/// ```
/// use bessemer::nalgebra::{Matrix1, Vector1};
/// use bessemer_blocks::{Outcome, RiccatiAdmm, RiccatiProgram};
///
/// // x(k+1) = x(k) + u(k), with w = 1 and so P = (Q + w) (1 + √5) / 2.
/// let one = Matrix1::new(1.0);
/// let last = one * (1.0 + 5.0_f64.sqrt());
/// let mut program = RiccatiProgram::new((&one, &one), (&one, &one), &last, 1.0, 1e-9).unwrap();
/// program.low[0] = -0.5;
/// program.high[0] = 0.5;
/// let mut solver = RiccatiAdmm::<f64, 1, 1, 8, 0, 0, 1000>::default();
/// let found = solver.step(&program, &Vector1::new(3.0), &Vector1::new(0.0));
/// assert_eq!((found.outcome, found.input[0]), (Outcome::Solved, -0.5));
/// ```
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct RiccatiAdmm<
    T: Real,
    const X: usize,
    const U: usize,
    const H: usize,
    const C: usize,
    const D: usize,
    const I: usize,
> {
    /// The inputs z, within their limits.
    inputs: [SVector<T, U>; H],
    /// Their remainders y.
    input_remainders: [SVector<T, U>; H],
    /// The states v(1), v(2), …, within their limits.
    states: [SVector<T, X>; H],
    /// Their remainders g.
    state_remainders: [SVector<T, X>; H],
}

impl<
    T: Real,
    const X: usize,
    const U: usize,
    const H: usize,
    const C: usize,
    const D: usize,
    const I: usize,
> Default for RiccatiAdmm<T, X, U, H, C, D, I>
{
    fn default() -> Self {
        RiccatiAdmm {
            inputs: [SVector::zeros(); H],
            input_remainders: [SVector::zeros(); H],
            states: [SVector::zeros(); H],
            state_remainders: [SVector::zeros(); H],
        }
    }
}

#[component]
impl<
    T: Real,
    const X: usize,
    const U: usize,
    const H: usize,
    const C: usize,
    const D: usize,
    const I: usize,
> RiccatiAdmm<T, X, U, H, C, D, I>
{
    /// Solves from the measured state, returns the first input, and moves the plan by one period.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        program: &RiccatiProgram<T, X, U>,
        measured: &SVector<T, X>,
        target: &SVector<T, X>,
    ) -> Receding<T, U> {
        let found = self.improve(program, measured, target);
        for k in 1..H {
            self.inputs[k - 1] = self.inputs[k];
            self.input_remainders[k - 1] = self.input_remainders[k];
            self.states[k - 1] = self.states[k];
            self.state_remainders[k - 1] = self.state_remainders[k];
        }
        found
    }

    /// Solves from the measured state as `step` does, and does not move the plan: repeated, it converges.
    #[entry(infallible)]
    pub fn improve(
        &mut self,
        program: &RiccatiProgram<T, X, U>,
        measured: &SVector<T, X>,
        target: &SVector<T, X>,
    ) -> Receding<T, U> {
        let weight = program.weight;
        let pull = program.state * target;
        let last_pull = program.last * target - target * weight;
        let mut offsets = [SVector::<T, U>::zeros(); H];
        let mut input_gaps = offsets;
        let mut state_gaps = [SVector::<T, X>::zeros(); H];
        let mut residual = T::ZERO;
        let mut violation = T::ZERO;
        for _ in 0..I {
            let mut slope = SVector::<T, X>::zeros();
            for k in (0..H).rev() {
                let linear = (self.state_remainders[k] - self.states[k]) * weight;
                slope = if k + 1 == H { linear - last_pull } else { slope + linear - pull };
                let own = (self.input_remainders[k] - self.inputs[k]) * weight;
                offsets[k] = program.inverse * (program.by_input.tr_mul(&slope) + own);
                slope = program.closed.tr_mul(&slope) - program.gain.tr_mul(&own);
            }

            let mut state = *measured;
            residual = T::ZERO;
            violation = T::ZERO;
            for k in 0..H {
                let input = -(program.gain * state) - offsets[k];
                state = program.by_state * state + program.by_input * input;
                let mut inputs = input + self.input_remainders[k];
                project::<T, U, C, D>(&mut inputs, &program.low, &program.high);
                let states =
                    (state + self.state_remainders[k]).sup(&program.lowest).inf(&program.highest);
                let changed =
                    (inputs - self.inputs[k]).amax().max((states - self.states[k]).amax());
                residual = residual.max(changed * weight);
                input_gaps[k] = input - inputs;
                state_gaps[k] = state - states;
                violation = violation.max(input_gaps[k].amax()).max(state_gaps[k].amax());
                self.inputs[k] = inputs;
                self.states[k] = states;
                self.input_remainders[k] += input_gaps[k];
                self.state_remainders[k] += state_gaps[k];
            }
        }

        let mut size = measured.norm_squared();
        for k in 0..H {
            size +=
                self.input_remainders[k].norm_squared() + self.state_remainders[k].norm_squared();
            size += self.inputs[k].norm_squared() + self.states[k].norm_squared();
        }
        let is_empty = proves::<T, X, U, H, C, D>(program, measured, &input_gaps, &state_gaps);
        let outcome = if is_empty {
            Outcome::Infeasible
        } else if size.is_finite()
            && violation <= program.tolerance
            && residual <= program.tolerance
        {
            Outcome::Solved
        } else {
            Outcome::Unfinished
        };
        let mut input = self.inputs[0];
        if is_empty || !size.is_finite() {
            self.inputs = [SVector::zeros(); H];
            self.input_remainders = self.inputs;
            self.states = [SVector::zeros(); H];
            self.state_remainders = self.states;
            input = SVector::zeros();
            project::<T, U, C, D>(&mut input, &program.low, &program.high);
        }
        Receding { input, outcome, violation }
    }
}

/// Returns true if limits exclude each other, or remainders of one iteration separate them from every plan.
#[function]
fn proves<
    T: Real,
    const X: usize,
    const U: usize,
    const H: usize,
    const C: usize,
    const D: usize,
>(
    program: &RiccatiProgram<T, X, U>,
    measured: &SVector<T, X>,
    input_gaps: &[SVector<T, U>; H],
    state_gaps: &[SVector<T, X>; H],
) -> bool {
    for i in 0..X {
        if program.lowest[i] > program.highest[i] {
            return true;
        }
    }
    for i in 0..(U as u32).saturating_sub((C * D) as u32) as usize {
        if program.low[i] > program.high[i] {
            return true;
        }
    }
    let mut size = T::ZERO;
    for k in 0..H {
        size = size.max(input_gaps[k].amax()).max(state_gaps[k].amax());
    }
    let small = size * real(1e-3);
    let (mut most, mut steepest) = (T::ZERO, T::ZERO);
    let mut slope = SVector::<T, X>::zeros();
    for k in (0..H).rev() {
        slope += state_gaps[k];
        steepest = steepest.max((input_gaps[k] + program.by_input.tr_mul(&slope)).amax());
        slope = program.by_state.tr_mul(&slope);
        let inputs = support::<T, U, C, D>(&input_gaps[k], &program.low, &program.high, small);
        let states =
            support::<T, X, 0, 0>(&state_gaps[k], &program.lowest, &program.highest, small);
        most += inputs + states;
    }
    steepest <= small && most < slope.dot(measured) - small
}
