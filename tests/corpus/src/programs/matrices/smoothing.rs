//! A smoother of a filter's record, and models of motion over a period.

use bessemer::prelude::*;
use bessemer_estimation::{
    Estimate, Rooted, Symmetric, UpperTriangular, exponential, runge_kutta, runge_kutta_jacobian, smoothed,
};

/// Transition of place and speed over a second.
#[function]
fn transition() -> Matrix2<f64> {
    Matrix2::new(1.0, 1.0, 0.0, 1.0)
}

/// Filters three measured places, m, and smooths them backwards; returns the smoothed states by columns, zeros if a covariance is lost.
#[function]
pub fn track(measured: &Vector3<f64>, variance: f64) -> Matrix2x3<f64> {
    let f = transition();
    let start = Estimate { state: Vector2::zeros(), covariance: Symmetric::diagonal(&Vector2::new(100.0, 10.0)) };
    let mut filtered = [start; 3];
    let mut predicted = [start; 3];
    for step in 0..3 {
        if step > 0 {
            let mut ahead = filtered[step - 1];
            ahead.state = f * ahead.state;
            ahead.covariance.congruence(&f);
            ahead.covariance.add_diagonal(&Vector2::new(0.1, 0.2));
            predicted[step] = ahead;
        }
        let mut now = predicted[step];
        let innovation = measured[step] - now.state[0];
        now.covariance.correct_element(&mut now.state, 0, innovation, variance, 1e9);
        filtered[step] = now;
    }
    let mut states = Matrix2x3::zeros();
    let mut next = filtered[2];
    states.set_column(2, &next.state);
    for back in 0..2 {
        let step = 1 - back;
        match smoothed(&filtered[step], &f, &predicted[step + 1], &next) {
            Some(estimate) => next = estimate,
            None => return Matrix2x3::zeros(),
        }
        states.set_column(step, &next.state);
    }
    states
}

/// Rate of a pendulum: of its angle, rad, and of its rate, rad/s.
#[function]
fn swing(state: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(state[1], -9.81 * state[0].sin() - 0.1 * state[1])
}

/// A pendulum after a period, s.
#[function]
pub fn swung(state: &Vector2<f64>, period: f64) -> Vector2<f64> {
    runge_kutta(state, period, |state| swing(state))
}

/// Rate of a pendulum, and its Jacobian.
#[function]
fn swing_jacobian(state: &Vector2<f64>) -> (Vector2<f64>, Matrix2<f64>) {
    (swing(state), Matrix2::new(0.0, 1.0, -9.81 * state[0].cos(), -0.1))
}

/// A pendulum after a period, s, and its Jacobian by the state before.
#[function]
pub fn swung_jacobian(state: &Vector2<f64>, period: f64) -> (Vector2<f64>, Matrix2<f64>) {
    runge_kutta_jacobian(state, period, |state| swing_jacobian(state))
}

/// The exponential of a matrix in single precision.
#[function]
pub fn turned(matrix: &Matrix2<f32>) -> Matrix2<f32> {
    exponential(matrix, 4)
}

/// A covariance by its root, predicted; one variance removed if it stays positive.
#[function]
pub fn by_root(p: &Matrix2<f64>, removed: &Vector2<f64>) -> (bool, Matrix2<f64>) {
    let Some(start) = Rooted::of(&Symmetric::of_lower(p)) else {
        return (false, *p);
    };
    let mut root = start;
    root.predict(&transition(), &Vector2::new(0.1, 0.2));
    let kept = root.remove(removed);
    (kept, *root.covariance().matrix())
}

/// Solves by an upper triangle, and multiplies back; zeros if its diagonal has one.
#[function]
pub fn triangle(elements: &Matrix3<f64>, right: &Vector3<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    let upper = UpperTriangular { elements: *elements };
    match upper.solve(right) {
        Some(solution) => (upper.times(&solution), *upper.square().matrix()),
        None => (Vector3::zeros(), upper.matrix()),
    }
}
