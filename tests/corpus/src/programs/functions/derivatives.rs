//! `#[function(derivative(f, x))]`: the value of a function and its Jacobian by some of its parameters. The generator writes
//! the body, with the branches and loops of the function; zeros and ones are not computed.

use bessemer::prelude::*;

/// Position, m, and velocity, m/s, in the plane after one period, s. Drag depends on the speed.
#[function]
pub fn advanced(state: &Vector4<f64>, push: f64, period: f64) -> Vector4<f64> {
    let speed = (state[2] * state[2] + state[3] * state[3]).sqrt();
    let drag = if speed > 2.0 { 0.25 * speed } else { 0.5 };
    let mut next = *state;
    for axis in 0..2 {
        let braking = drag * state[axis + 2];
        next[axis] += period * state[axis + 2];
        next[axis + 2] -= period * braking;
    }
    next[2] += period * push;
    next
}

/// The next state with its Jacobians by the state and by the push.
#[function(derivative(advanced, state, push))]
pub fn advanced_jacobian(
    state: &Vector4<f64>,
    push: f64,
    period: f64,
) -> (Vector4<f64>, Matrix4<f64>, Vector4<f64>) {
    let speed = (state[2] * state[2] + state[3] * state[3]).sqrt();
    let twice = 2.0 * speed;
    let speed_d2 = (state[2] + state[2]) / twice;
    let speed_d3 = (state[3] + state[3]) / twice;
    let drag: f64;
    let drag_d2: f64;
    let drag_d3: f64;
    if speed > 2.0 {
        let drag_2 = 0.25 * speed;
        let drag_d2_2 = 0.25 * speed_d2;
        let drag_d3_2 = 0.25 * speed_d3;
        drag = drag_2;
        drag_d2 = drag_d2_2;
        drag_d3 = drag_d3_2;
    } else {
        drag = 0.5;
        drag_d2 = 0.0;
        drag_d3 = 0.0;
    }
    let braking = drag * state[2];
    let braking_d2 = state[2] * drag_d2 + drag;
    let braking_d3 = state[2] * drag_d3;
    let next_0 = state[0] + period * state[2];
    let next_2 = state[2] - period * braking;
    let next_2_d2 = 1.0 - period * braking_d2;
    let next_2_d3 = -(period * braking_d3);
    let braking_2 = drag * state[3];
    let braking_d2_2 = state[3] * drag_d2;
    let braking_d3_2 = state[3] * drag_d3 + drag;
    let next_1 = state[1] + period * state[3];
    let next_3 = state[3] - period * braking_2;
    let next_3_d2 = -(period * braking_d2_2);
    let next_3_d3 = 1.0 - period * braking_d3_2;
    let next_2_2 = next_2 + period * push;
    let mut jacobian: SMatrix<f64, 4, 4> = SMatrix::zeros();
    jacobian[(0, 0)] = 1.0;
    jacobian[(0, 2)] = period;
    jacobian[(1, 1)] = 1.0;
    jacobian[(1, 3)] = period;
    jacobian[(2, 2)] = next_2_d2;
    jacobian[(2, 3)] = next_2_d3;
    jacobian[(3, 2)] = next_3_d2;
    jacobian[(3, 3)] = next_3_d3;
    let mut jacobian_2: SVector<f64, 4> = SVector::zeros();
    jacobian_2[2] = period;
    (vector![next_0, next_1, next_2_2, next_3], jacobian, jacobian_2)
}

/// Range, m, and bearing, rad, of a place seen from a beacon.
#[function]
pub fn seen(place: &Vector2<f64>, beacon: &Vector2<f64>) -> Vector2<f64> {
    let way = place - beacon;
    Vector2::new(way.norm(), way[1].atan2(way[0]))
}

/// Range and bearing with their Jacobian by the place.
#[function(derivative(seen, place))]
pub fn seen_jacobian(
    place: &Vector2<f64>,
    beacon: &Vector2<f64>,
) -> (Vector2<f64>, Matrix2<f64>) {
    let way_0 = place[0] - beacon[0];
    let way_1 = place[1] - beacon[1];
    let result = (0.0 + (way_0 * way_0 + way_1 * way_1)).sqrt();
    let twice = 2.0 * result;
    let atan2_way_1 = way_1.atan2(way_0);
    let radius = way_0 * way_0 + way_1 * way_1;
    let slope = way_0 / radius;
    let slope_2 = way_1 / radius;
    let result_0_d0 = (way_0 + way_0) / twice;
    let result_0_d1 = (way_1 + way_1) / twice;
    let result_1_d0 = -slope_2;
    let mut jacobian: SMatrix<f64, 2, 2> = SMatrix::zeros();
    jacobian[(0, 0)] = result_0_d0;
    jacobian[(0, 1)] = result_0_d1;
    jacobian[(1, 0)] = result_1_d0;
    jacobian[(1, 1)] = slope;
    (vector![result, atan2_way_1], jacobian)
}

/// A polynomial by Horner's rule; a long loop stays a loop.
#[function]
pub fn horner(coefficients: &[f32; 40], x: f32) -> f32 {
    let mut sum = 0.0;
    for coefficient in coefficients {
        sum = sum * x + *coefficient;
    }
    sum
}

/// The polynomial with its slope.
#[function(derivative(horner, x))]
pub fn horner_slope(coefficients: &[f32; 40], x: f32) -> (f32, f32) {
    let mut sum: f32 = 0.0;
    let mut sum_d0: f32 = 0.0;
    for i in 0..40 {
        let sum_2 = sum * x + coefficients[i];
        let sum_d0_2 = x * sum_d0 + sum;
        sum_d0 = sum_d0_2;
        sum = sum_2;
    }
    (sum, sum_d0)
}
