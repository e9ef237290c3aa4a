//! Predictive controls against converged solvers of other kinds: SLSQP for a pendulum on a cart, Clarabel for a mass.

use bessemer::nalgebra::{Matrix3, Matrix4, RowVector4, SMatrix, SVector, Vector1, Vector4};
use bessemer::prelude::{Real, real};
use bessemer_blocks::*;

use crate::data::{Data, near};

const PERIODS: usize = 20;

type Swing<T> = RealTimeIteration<T, 4, 1, 1, PERIODS, PERIODS, 40, 30>;

/// The law of `receding` in `generate.py`, with its Jacobians.
fn swung<T: Real>(state: &Vector4<T>, push: &Vector1<T>) -> (Vector4<T>, Matrix4<T>, Vector4<T>) {
    let (h, length, drag) = (real::<T>(0.05), real::<T>(0.5), real::<T>(0.1));
    let (sine, cosine) = state[1].sin_cos();
    let gravity = real::<T>(9.81);
    let turn = (gravity * sine - push[0] * cosine) / length - drag * state[3];
    let (speed, rate) = (state[2] + h * push[0], state[3] + h * turn);
    let next = Vector4::new(state[0] + h * speed, state[1] + h * rate, speed, rate);
    let slope = h * (gravity * cosine + push[0] * sine) / length;
    let (zero, one) = (T::ZERO, T::ONE);
    let kept = one - drag * h;
    #[rustfmt::skip]
    let by_state = Matrix4::new(
        one, zero, h, zero,
        zero, one + h * slope, zero, h * kept,
        zero, zero, one, zero,
        zero, slope, zero, kept,
    );
    let turned = -h * cosine / length;
    (next, by_state, Vector4::new(h * h, h * turned, h, turned))
}

fn horizon<T: Real>(tolerance: f64) -> Horizon<T, 4, 1, 1> {
    let weights = Vector4::new(2.0, 4.0, 0.1, 0.2).map(real::<T>);
    Horizon {
        state: Matrix4::from_diagonal(&weights),
        last: Matrix4::from_diagonal(&(weights * real::<T>(20.0))),
        input: SMatrix::repeat(real(0.01)),
        rest: Vector1::repeat(T::ZERO),
        low: Vector1::repeat(real(-12.0)),
        high: Vector1::repeat(real(12.0)),
        outputs: RowVector4::new(T::ONE, T::ZERO, T::ZERO, T::ZERO),
        lowest: Vector1::repeat(real(-0.8)),
        highest: Vector1::repeat(real(0.8)),
        tolerance: real(tolerance),
    }
}

fn converged<T: Real>(tolerance: f64, digits: i32) {
    let data = Data::read(include_str!("../data/receding.txt"));
    let targets = [Vector4::zeros(); PERIODS];
    for index in 0..3 {
        let start = Vector4::from(data.all::<T, 4>(&format!("start_{index}")));
        let mut control = Swing::<T>::default();
        control.begin(&start, &Vector1::zeros());
        for _ in 0..25 {
            let _ = control.improve(&horizon(tolerance), &start, &targets, swung);
        }
        // A converged plan moves along itself.
        let mut state = start;
        let plan = data.get::<T>(&format!("plan_{index}"));
        let first = control.step(&horizon(tolerance), &state, &targets, swung);
        assert_eq!(first.outcome, Outcome::Solved);
        near(first.input.as_slice(), &plan[..1], digits);
        state = swung(&state, &first.input).0;
        assert!(state.iter().all(|it| it.is_finite()));
    }
}

#[test]
fn repeated_improvements_find_the_best_plan() {
    converged::<f64>(1e-9, 5);
    converged::<f32>(1e-4, 12);
}

/// One improvement in a period costs hardly more than the best plan in each.
#[test]
fn one_improvement_in_a_period_is_nearly_the_best() {
    let data = Data::read(include_str!("../data/receding.txt"));
    let track = data.rows::<f64, 4>("track");
    let mut state = Vector4::new(-0.5, 0.4, 0.0, 0.0);
    let mut control = Swing::<f64>::default();
    control.begin(&state, &Vector1::zeros());
    let (mut cost, horizon) = (0.0, horizon(1e-6));
    for (k, expected) in track.iter().enumerate() {
        let found = control.step(&horizon, &state, &[Vector4::zeros(); PERIODS], swung);
        assert_eq!(found.outcome, Outcome::Solved, "{k}");
        state = swung(&state, &found.input).0;
        cost += 0.5 * state.dot(&(horizon.state * state)) + 0.005 * found.input[0].powi(2);
        let off = (state - Vector4::from(*expected)).norm();
        assert!(off < 0.1, "{k}: {state} is not {expected:?}");
    }
    let best = data.get::<f64>("track_cost")[0];
    assert!(cost < 1.01 * best, "{cost} is not {best}");
}

/// From hanging to upright, within the limits of the push and of the rail.
#[test]
fn a_pendulum_swings_up() {
    let mut state = Vector4::new(0.0, std::f64::consts::PI, 0.0, 0.0);
    let mut control = Swing::<f64>::default();
    control.begin(&state, &Vector1::zeros());
    for k in 0..120 {
        let found = control.step(&horizon(1e-6), &state, &[Vector4::zeros(); PERIODS], swung);
        assert_eq!(found.outcome, Outcome::Solved, "{k}");
        assert!(found.input[0].abs() <= 12.0, "{k}: {}", found.input);
        state = swung(&state, &found.input).0;
        assert!(state[0].abs() < 0.81, "{k}: {state}");
    }
    assert!(state.norm() < 1e-3, "{state}");
}

/// A plan takes nothing of a state that no push keeps on the rail, nor of NaN, and its inputs keep their limits.
#[test]
fn a_plan_outlives_what_has_no_solution() {
    let targets = [Vector4::zeros(); PERIODS];
    let mut control = RealTimeIteration::<f64, 4, 1, 1, PERIODS, PERIODS, 40, 200>::default();
    let near = Vector4::new(0.1, 0.1, 0.0, 0.0);
    control.begin(&near, &Vector1::zeros());
    for (state, outcome) in [
        (near, Outcome::Solved),
        (Vector4::new(0.79, 0.1, 3.0, 0.0), Outcome::Infeasible),
        (Vector4::new(f64::NAN, 0.1, 0.0, 0.0), Outcome::Unfinished),
        (near, Outcome::Solved),
    ] {
        let found = control.improve(&horizon(1e-6), &state, &targets, swung);
        assert_eq!(found.outcome, outcome, "{state}");
        assert!(found.input[0].abs() <= 12.0, "{}", found.input);
    }
}

fn split<T: Real, const C: usize>(data: &Data, tolerance: f64, digits: i32) {
    let matrix = |name| SMatrix::<T, 6, 6>::from_row_slice(&data.get(name));
    let by_input = SMatrix::<T, 6, 3>::from_row_slice(&data.get("b"));
    let input = Matrix3::from_row_slice(&data.get("r"));
    let mut program = RiccatiProgram::new(
        (&matrix("a"), &by_input),
        (&matrix("q"), &input),
        &matrix("last"),
        real(2.0),
        real(tolerance),
    )
    .expect("definite");
    let goal = SVector::from(data.all::<T, 6>("goal"));
    let mut solver = RiccatiAdmm::<T, 6, 3, 8, C, 3, 800>::default();
    for index in (C..12).step_by(2) {
        let numbers = |name| format!("{name}_{index}");
        program.low = SVector::from(data.all::<T, 3>(&numbers("low")));
        program.high = SVector::from(data.all::<T, 3>(&numbers("high")));
        program.lowest = SVector::from(data.all::<T, 6>(&numbers("lowest")));
        program.highest = SVector::from(data.all::<T, 6>(&numbers("highest")));
        let expected = data.get::<T>(&numbers("input"));
        let found = solver.step(&program, &SVector::from(data.all::<T, 6>(&numbers("x"))), &goal);
        if expected.is_empty() {
            assert_eq!(found.outcome, Outcome::Infeasible, "{index}: {}", found.violation);
        } else {
            assert_eq!(found.outcome, Outcome::Solved, "{index}: {}", found.violation);
            near(found.input.as_slice(), &expected, digits);
        }
    }
}

#[test]
fn riccati_recursions_find_the_minimum_or_that_there_is_none() {
    let data = Data::read(include_str!("../data/riccati.txt"));
    split::<f64, 0>(&data, 1e-9, 7);
    split::<f64, 1>(&data, 1e-9, 7);
    split::<f32, 0>(&data, 1e-4, 12);
    split::<f32, 1>(&data, 1e-4, 12);
}

/// Neither a number that is none, nor limits that exclude each other, nor too few iterations count as solved.
#[test]
fn no_other_outcome_of_a_recursion_counts_as_solved() {
    let one = SMatrix::<f64, 1, 1>::repeat(1.0);
    let last = one * (1.0 + 5_f64.sqrt());
    let mut program =
        RiccatiProgram::new((&one, &one), (&one, &one), &last, 1.0, 1e-9).expect("definite");
    let mut solver = RiccatiAdmm::<f64, 1, 1, 4, 0, 0, 2>::default();
    for (state, low, outcome) in [
        (0.0, -1.0, Outcome::Solved),
        (f64::NAN, -1.0, Outcome::Unfinished),
        (50.0, -1.0, Outcome::Unfinished),
        (0.0, 2.0, Outcome::Infeasible),
        (0.0, -1.0, Outcome::Solved),
    ] {
        (program.low[0], program.high[0]) = (low, 1.0);
        let found = solver.improve(&program, &Vector1::new(state), &Vector1::zeros());
        assert_eq!(found.outcome, outcome, "{state} {low}");
        assert!(found.input[0].abs() <= 1.0, "{}", found.input);
        if outcome == Outcome::Unfinished {
            solver = RiccatiAdmm::default();
        }
    }
    assert!(RiccatiProgram::new((&one, &one), (&one, &-last), &-last, 1.0, 1e-9).is_none());
}
