//! `#[function(gradient(cost, inputs))]`: a number and its gradient in reverse mode, in a few times the cost of the number.

use bessemer::prelude::*;

/// Rate of a pendulum with drag, rad/s, and its acceleration under a torque.
#[function]
pub fn rate(state: &Vector2<f64>, torque: f64) -> Vector2<f64> {
    let drag = if state[1] > 1.0 { 0.25 * state[1] * state[1] } else { 0.5 * state[1] };
    Vector2::new(state[1], torque - state[0].sin() - drag)
}

/// Cost of a pendulum's way to the top under 50 torques; the way ends above it.
#[function]
pub fn rollout_cost(start: &Vector2<f64>, torques: &SVector<f64, 50>) -> f64 {
    let mut state = *start;
    let mut cost = 0.0;
    for k in 0..50 {
        let torque = torques[k];
        state += rate(&state, torque) * 0.05;
        cost += 0.01 * torque * torque;
        if state[0] > 4.0 {
            break;
        }
        cost += state[1].abs() * 0.001;
    }
    let left = state[0] - 3.0;
    cost + left * left
}

/// The cost with its gradients by the start and by the torques.
#[function(gradient(rollout_cost, start, torques))]
pub fn rollout_gradient(
    start: &Vector2<f64>,
    torques: &SVector<f64, 50>,
) -> (f64, Vector2<f64>, SVector<f64, 50>) {
    let mut cost_kept: [f64; 50] = [0.0; 50];
    let mut state_1_kept: [f64; 50] = [0.0; 50];
    let mut state_0_kept: [f64; 50] = [0.0; 50];
    let mut state_1_kept_2: [f64; 50] = [0.0; 50];
    let mut state_0_kept_2: [f64; 50] = [0.0; 50];
    let mut state_0 = start[0];
    let mut state_1 = start[1];
    let mut cost: f64 = 0.0;
    let mut last: usize = 0;
    for k in 0..50 {
        last = k;
        let state_0_before = state_0;
        state_0_kept[k] = state_0_before;
        let state_1_before = state_1;
        state_1_kept[k] = state_1_before;
        let cost_before = cost;
        let drag: f64;
        if state_1_before > 1.0 {
            let drag_2 = 0.25 * state_1_before;
            let drag_3 = drag_2 * state_1_before;
            drag = drag_3;
        } else {
            let drag_2 = 0.5 * state_1_before;
            drag = drag_2;
        }
        let sin_state_0 = state_0_before.sin();
        let torques_at = torques[k];
        let rate_1 = torques_at - sin_state_0 - drag;
        let state_0_2 = state_1_before * 0.05;
        let state_1_2 = rate_1 * 0.05;
        let state_0_3 = state_0_before + state_0_2;
        state_0_kept_2[k] = state_0_3;
        let state_1_3 = state_1_before + state_1_2;
        state_1_kept_2[k] = state_1_3;
        let cost_2 = 0.01 * torques_at;
        let cost_3 = cost_before + cost_2 * torques_at;
        if state_0_3 > 4.0 {
            state_0 = state_0_3;
            state_1 = state_1_3;
            cost = cost_3;
            break;
        } else {
            let cost_4 = state_1_3.abs();
            cost_kept[k] = cost_4;
            let cost_5 = cost_3 + cost_4 * 0.001;
            state_0 = state_0_3;
            state_1 = state_1_3;
            cost = cost_5;
        }
    }
    let left = state_0 - 3.0;
    let result = cost + left * left;
    let mut torques_bar: SVector<f64, 50> = SVector::zeros();
    let left_bar = left * 2.0;
    let mut state_0_bar = left_bar;
    let mut state_1_bar: f64 = 0.0;
    let cost_bar: f64 = 1.0;
    for k in (0..50).rev() {
        if k <= last {
            let state_1_bar_2: f64;
            if state_0_kept_2[k] > 4.0 {
                state_1_bar_2 = state_1_bar;
            } else {
                let cost_bar_2 = 0.001 * cost_bar;
                let slope_d0: f64;
                if cost_kept[k] == state_1_kept_2[k] {
                    slope_d0 = 1.0;
                } else {
                    slope_d0 = -1.0;
                }
                state_1_bar_2 = state_1_bar + slope_d0 * cost_bar_2;
            }
            let cost_bar_2 = torques[k] * cost_bar;
            let rate_1_bar = 0.05 * state_1_bar_2;
            let torques_at_bar = 0.01 * torques[k] * cost_bar + 0.01 * cost_bar_2 + rate_1_bar;
            torques_bar[k] = torques_at_bar;
            let sin_state_0_bar = -rate_1_bar;
            let cos_state_0_before = state_0_kept[k].cos();
            let drag_bar = -rate_1_bar;
            let state_1_before_bar: f64;
            if state_1_kept[k] > 1.0 {
                let drag_bar_2 = state_1_kept[k] * drag_bar;
                state_1_before_bar = 0.25 * state_1_kept[k] * drag_bar + 0.25 * drag_bar_2;
            } else {
                state_1_before_bar = 0.5 * drag_bar;
            }
            let state_1_before_bar_2 = state_1_bar_2 + 0.05 * state_0_bar + state_1_before_bar;
            let state_0_before_bar = state_0_bar + cos_state_0_before * sin_state_0_bar;
            state_0_bar = state_0_before_bar;
            state_1_bar = state_1_before_bar_2;
        }
    }
    (result, vector![state_0_bar, state_1_bar], torques_bar)
}

/// Squared residual of a line through points, weighted by a covariance that may not be positive definite.
#[function]
pub fn misfit(line: &Vector2<f32>, covariance: &Matrix2<f32>) -> f32 {
    let residual = Vector2::new(line[0] - 1.0, line[0] * line[1] + 0.5);
    match covariance.cholesky() {
        Some(factor) => residual.dot(&factor.solve(&residual)),
        None => residual.norm_squared(),
    }
}

/// The squared residual with its gradient by the line and by the covariance.
#[function(gradient(misfit, line, covariance))]
pub fn misfit_gradient(
    line: &Vector2<f32>,
    covariance: &Matrix2<f32>,
) -> (f32, Vector2<f32>, Matrix2<f32>) {
    let mut result: f32 = 0.0;
    let mut result_2: f32 = 0.0;
    let mut solution: SVector<f32, 2> = SVector::zeros();
    let residual_0 = line[0] - 1.0;
    let residual_1 = line[0] * line[1] + 0.5;
    let lower = bessemer::linear::kernels::cholesky_lower(covariance);
    let factor_0 = lower[(0, 0)] > 0.0;
    let result_3: f32;
    if factor_0 {
        solution = vector![residual_0, residual_1];
        bessemer::linear::kernels::cholesky_solve_mut(&lower, &mut solution);
        result_2 = solution[0];
        result = solution[1];
        let result_4 = residual_0 * result_2 + residual_1 * result;
        result_3 = result_4;
    } else {
        let result_4 = 0.0 + (residual_0 * residual_0 + residual_1 * residual_1);
        result_3 = result_4;
    }
    let residual_0_bar: f32;
    let residual_1_bar: f32;
    let lower_bar: f32;
    let lower_bar_2: f32;
    let lower_bar_3: f32;
    if factor_0 {
        let mut solution_bar = vector![residual_0, residual_1];
        bessemer::linear::kernels::cholesky_solve_mut(&lower, &mut solution_bar);
        residual_0_bar = result_2 + solution_bar[0];
        residual_1_bar = result + solution_bar[1];
        lower_bar = -(solution_bar[0] * solution[0]);
        lower_bar_2 = -(solution_bar[1] * solution[0] + solution_bar[0] * solution[1]);
        lower_bar_3 = -(solution_bar[1] * solution[1]);
    } else {
        residual_0_bar = residual_0 * 2.0;
        residual_1_bar = residual_1 * 2.0;
        lower_bar = 0.0;
        lower_bar_2 = 0.0;
        lower_bar_3 = 0.0;
    }
    (result_3, vector![line[1] * residual_1_bar + residual_0_bar, line[0] * residual_1_bar], matrix![lower_bar, 0.0; lower_bar_2, lower_bar_3])
}

/// The gradient at a point of a straight way through it.
#[function]
pub fn gradient_along(line: &Vector2<f32>, way: &Vector2<f32>, length: f32) -> Vector2<f32> {
    let (_, gradient, _) = misfit_gradient(&(line + way * length), &Matrix2::identity());
    gradient
}

/// The gradient with the product of the Hessian and the way.
#[function(derivative(gradient_along, length))]
pub fn hessian_product(
    line: &Vector2<f32>,
    way: &Vector2<f32>,
    length: f32,
) -> (Vector2<f32>, Vector2<f32>) {
    let pair_0 = way[0] * length;
    let pair_1 = way[1] * length;
    let line_0 = line[0] + pair_0;
    let line_1 = line[1] + pair_1;
    let residual_0 = line_0 - 1.0;
    let residual_1 = line_0 * line_1 + 0.5;
    let residual_1_d0 = line_1 * way[0] + line_0 * way[1];
    let lower = bessemer::linear::kernels::cholesky_lower(&matrix![1.0, 0.0; 0.0, 1.0]);
    let factor_0 = lower[(0, 0)] > 0.0;
    let result_2: f32;
    let result_2_d0: f32;
    let result: f32;
    let result_d0: f32;
    if factor_0 {
        let mut solution = vector![residual_0, residual_1];
        bessemer::linear::kernels::cholesky_solve_mut(&lower, &mut solution);
        let mut solution_d = vector![way[0], residual_1_d0];
        bessemer::linear::kernels::cholesky_solve_mut(&lower, &mut solution_d);
        result_2 = solution[0];
        result_2_d0 = solution_d[0];
        result = solution[1];
        result_d0 = solution_d[1];
    } else {
        result_2 = 0.0;
        result_2_d0 = 0.0;
        result = 0.0;
        result_d0 = 0.0;
    }
    let residual_0_bar: f32;
    let residual_0_bar_d0: f32;
    let residual_1_bar: f32;
    let residual_1_bar_d0: f32;
    if factor_0 {
        let mut solution = vector![residual_0, residual_1];
        bessemer::linear::kernels::cholesky_solve_mut(&lower, &mut solution);
        let mut solution_d = vector![way[0], residual_1_d0];
        bessemer::linear::kernels::cholesky_solve_mut(&lower, &mut solution_d);
        let residual_0_bar_2 = result_2 + solution[0];
        let residual_0_bar_d0_2 = result_2_d0 + solution_d[0];
        let residual_1_bar_2 = result + solution[1];
        let residual_1_bar_d0_2 = result_d0 + solution_d[1];
        residual_0_bar = residual_0_bar_2;
        residual_0_bar_d0 = residual_0_bar_d0_2;
        residual_1_bar = residual_1_bar_2;
        residual_1_bar_d0 = residual_1_bar_d0_2;
    } else {
        let residual_0_bar_2 = residual_0 * 2.0;
        let residual_0_bar_d0_2 = 2.0 * way[0];
        let residual_1_bar_2 = residual_1 * 2.0;
        let residual_1_bar_d0_2 = 2.0 * residual_1_d0;
        residual_0_bar = residual_0_bar_2;
        residual_0_bar_d0 = residual_0_bar_d0_2;
        residual_1_bar = residual_1_bar_2;
        residual_1_bar_d0 = residual_1_bar_d0_2;
    }
    let pair_1_0 = line_1 * residual_1_bar + residual_0_bar;
    let pair_1_0_d0 = residual_1_bar * way[1] + line_1 * residual_1_bar_d0 + residual_0_bar_d0;
    let pair_1_1 = line_0 * residual_1_bar;
    let pair_1_1_d0 = residual_1_bar * way[0] + line_0 * residual_1_bar_d0;
    let mut jacobian: SVector<f32, 2> = SVector::zeros();
    jacobian[0] = pair_1_0_d0;
    jacobian[1] = pair_1_1_d0;
    (vector![pair_1_0, pair_1_1], jacobian)
}

/// Cost of the errors of a recorded window under a filter with this share of the old value.
#[function]
pub fn window_cost(share: f64, errors: &List<f64, 40>) -> f64 {
    let mut level = 0.0;
    let mut cost = 0.0;
    for error in errors {
        level = share * level + (1.0 - share) * error;
        cost += level * level;
    }
    cost
}

/// The cost with its derivative by the share. The list limits the passes, so their values are in arrays of its capacity.
#[function(gradient(window_cost, share))]
pub fn window_slope(share: f64, errors: &List<f64, 40>) -> (f64, f64) {
    let mut level_kept: [f64; 40] = [0.0; 40];
    let mut level_kept_2: [f64; 40] = [0.0; 40];
    let mut level: f64 = 0.0;
    let mut cost: f64 = 0.0;
    for i in 0..errors.len().min(40) {
        let level_before = level;
        level_kept[i] = level_before;
        let cost_before = cost;
        let level_2 = share * level_before + (1.0 - share) * errors[i];
        level_kept_2[i] = level_2;
        let cost_2 = cost_before + level_2 * level_2;
        level = level_2;
        cost = cost_2;
    }
    let mut level_bar: f64 = 0.0;
    let cost_bar: f64 = 1.0;
    let mut share_bar: f64 = 0.0;
    for i in (0..errors.len().min(40)).rev() {
        let level_bar_2 = level_bar + level_kept_2[i] * (2.0 * cost_bar);
        let level_before_bar = share * level_bar_2;
        share_bar = share_bar + (level_kept[i] * level_bar_2 - errors[i] * level_bar_2);
        level_bar = level_before_bar;
    }
    (cost, share_bar)
}
