//! Matrices of blocks, most of which are zero by their type: the pattern is a picture, and only the stored blocks are
//! multiplied.

use bessemer::prelude::*;
use bessemer_estimation::{BlockSparse, Symmetric, pattern, stored};

/// The blocks of a step: position, velocity and bias of an accelerometer, each in the plane.
const STEP: u64 = pattern(&["xx.", ".xx", "..x"]);

/// The blocks of two steps.
const TWO_STEPS: u64 = pattern(&["xxx", ".xx", "..x"]);

/// The Jacobian of a step.
#[data]
pub type Step = BlockSparse<f64, 6, 6, 2, { stored(STEP) }, STEP>;

/// The Jacobian of two steps.
#[data]
pub type TwoSteps = BlockSparse<f64, 6, 6, 2, { stored(TWO_STEPS) }, TWO_STEPS>;

/// The Jacobian of a step of this period, s.
#[function]
fn step(period: f64) -> Step {
    let mut step = Step::zeros();
    step.set::<0, 0>(&Matrix2::identity());
    step.set::<1, 1>(&Matrix2::identity());
    step.set::<2, 2>(&Matrix2::identity());
    step.set::<0, 1>(&Matrix2::new(period, 0.0, 0.0, period));
    step.set::<1, 2>(&Matrix2::new(-period, 0.0, 0.0, -period));
    step
}

/// The state after a step, and the covariance of its errors.
#[function]
pub fn predicted(
    state: &SVector<f64, 6>,
    covariance: &SMatrix<f64, 6, 6>,
    period: f64,
) -> (SVector<f64, 6>, SMatrix<f64, 6, 6>) {
    let step = step(period);
    let after = step.congruence(&Symmetric::of_lower(covariance));
    (step.times(state), *after.matrix())
}

/// The Jacobian of two steps, and its sum with one.
#[function]
pub fn two_steps(period: f64) -> (SMatrix<f64, 6, 6>, SMatrix<f64, 6, 6>) {
    let step = step(period);
    let both: TwoSteps = step.product(&step);
    let sum: TwoSteps = step.sum(&both);
    (both.matrix(), sum.matrix())
}

/// The position and the bias that are measured.
const MEASURED: u64 = pattern(&["x..", "..x"]);

/// Corrects a state and its covariance by a measured position and bias; returns the surprise.
#[function]
pub fn corrected(
    covariance: &SMatrix<f64, 6, 6>,
    jacobian: &SMatrix<f64, 4, 6>,
    innovation: &Vector4<f64>,
) -> (f64, SVector<f64, 6>, SMatrix<f64, 6, 6>) {
    let jacobian = BlockSparse::<f64, 4, 6, 2, { stored(MEASURED) }, MEASURED>::of_matrix(jacobian);
    let (mut state, mut covariance) = (SVector::zeros(), Symmetric::of_lower(covariance));
    let noise = Symmetric::diagonal(&Vector4::repeat(0.25));
    let report = covariance.correct_sparse(&mut state, &jacobian, innovation, &noise, 30.0);
    (report.surprise, state, *covariance.matrix())
}

/// A gradient of a cost after a step, as one before it; and a block of the Jacobian.
#[function]
pub fn before(period: f32, gradient: &Vector4<f32>) -> (Vector4<f32>, Matrix2<f32>) {
    let mut step = BlockSparse::<f32, 4, 4, 2, 3, { pattern(&["xx", ".x"]) }>::zeros();
    step.set::<0, 0>(&Matrix2::identity());
    step.set::<1, 1>(&Matrix2::identity());
    step.set::<0, 1>(&Matrix2::new(period, 0.0, 0.0, period));
    (step.transposed_times(gradient), step.block::<0, 1>())
}
