//! Quadratic programs against an interior point, in sequence, so that each but the first begins at the last solution.

use bessemer::nalgebra::{SMatrix, SVector};
use bessemer::prelude::{Real, real};
use bessemer_blocks::*;

use crate::data::{Data, near};

const N: usize = 6;
const M: usize = 10;
const PROGRAMS: usize = 16;

fn vector<T: Real, const L: usize>(data: &Data, name: &str, index: usize) -> SVector<T, L> {
    SVector::from(data.all::<T, L>(&format!("{name}_{index}")))
}

fn matrix<T: Real, const R: usize>(data: &Data, name: &str) -> SMatrix<T, R, N> {
    SMatrix::from_row_slice(&data.get(name))
}

/// Holds a solver to the reference; an empty point marks an infeasible program.
fn held<T: Real>(
    data: &Data,
    point: &str,
    digits: i32,
    mut solved: impl FnMut(usize) -> Minimum<T, N>,
) {
    for index in 0..PROGRAMS {
        let expected = data.get::<T>(&format!("{point}_{index}"));
        let found = solved(index);
        if expected.is_empty() {
            assert_eq!(found.outcome, Outcome::Infeasible, "{index} {}", found.violation);
        } else {
            assert_eq!(found.outcome, Outcome::Solved, "{index}: {}", found.violation);
            near(found.point.as_slice(), &expected, digits);
        }
    }
}

fn by_active_set<T: Real>(tolerance: f64, digits: i32) {
    let data = Data::read(include_str!("../data/programs.txt"));
    let (hessian, rows) = (matrix(&data, "hessian"), matrix(&data, "rows"));
    let program = ActiveSetProgram::new(&hessian, &rows, real(tolerance)).expect("definite");
    let mut solver = ActiveSet::<T, N, M, 30>::default();
    held(&data, "point", digits, |index| {
        let gradient = vector(&data, "gradient", index);
        let (low, high) = (vector(&data, "low", index), vector(&data, "high", index));
        solver.step(&program, &gradient, &low, &high)
    });
}

fn by_admm<T: Real, const C: usize, const D: usize>(names: [&str; 2], tolerance: f64, digits: i32) {
    let data = Data::read(include_str!("../data/programs.txt"));
    let (hessian, rows) = (matrix(&data, "hessian"), matrix(&data, "rows"));
    let mut weights = SVector::repeat(real(3.0));
    weights[0] = real(30.0);
    let program = AdmmProgram::new(&hessian, &rows, &weights, real(tolerance)).expect("definite");
    let mut solver = Admm::<T, N, M, C, D, 2000>::default();
    held(&data, names[0], digits, |index| {
        let gradient = vector(&data, "gradient", index);
        let (low, high) = (vector(&data, names[1], index), vector(&data, "high", index));
        solver.step(&program, &gradient, &low, &high)
    });
}

#[test]
fn active_sets_find_the_minimum_or_that_there_is_none() {
    by_active_set::<f64>(1e-11, 9);
    by_active_set::<f32>(1e-4, 13);
}

#[test]
fn alternating_directions_find_the_minimum_or_that_there_is_none() {
    by_admm::<f64, 0, 0>(["point", "low"], 1e-9, 7);
    by_admm::<f32, 0, 0>(["point", "low"], 1e-4, 12);
}

#[test]
fn alternating_directions_find_the_minimum_in_cones() {
    by_admm::<f64, 2, 3>(["cone_point", "cone_low"], 1e-9, 7);
    by_admm::<f32, 2, 3>(["cone_point", "cone_low"], 1e-4, 12);
}

/// Neither a number that is none, nor limits that exclude each other, nor too few iterations count as solved.
#[test]
fn no_other_outcome_counts_as_solved() {
    let one = SMatrix::<f64, 2, 2>::identity();
    let (low, high) = (SVector::from([-1.0, -1.0]), SVector::from([1.0, 1.0]));
    let exact = ActiveSetProgram::new(&one, &one, 1e-9).expect("definite");
    let split = AdmmProgram::new(&one, &one, &SVector::repeat(1.0), 1e-9).expect("definite");
    let crossed = SVector::from([2.0, -1.0]);
    let mut exactly = ActiveSet::<f64, 2, 2, 2>::default();
    let mut nearly = Admm::<f64, 2, 2, 0, 0, 2>::default();
    for (gradient, low, outcome) in [
        (SVector::from([0.0, 0.0]), low, Outcome::Solved),
        (SVector::from([f64::NAN, 0.0]), low, Outcome::Unfinished),
        (SVector::from([5.0, 5.0]), low, Outcome::Unfinished),
        (SVector::from([5.0, 5.0]), crossed, Outcome::Infeasible),
        (SVector::from([0.0, 0.0]), low, Outcome::Solved),
    ] {
        let found = exactly.step(&exact, &gradient, &low, &high);
        assert_eq!(found.outcome, outcome, "{gradient} {low}");
        let found = nearly.step(&split, &gradient, &low, &high);
        assert_eq!(found.outcome, outcome, "{gradient} {low}");
    }
    assert!(ActiveSetProgram::new(&-one, &one, 1e-9).is_none());
    assert!(AdmmProgram::new(&(one * -2.0), &one, &SVector::repeat(1.0), 1e-9).is_none());
}
