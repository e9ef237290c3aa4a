//! Calls of `s_curve` over plain numbers.

use crate::*;

/// Keeps a limit where the original's recursion ends before its stack does.
fn kept(limit: f64) -> f64 {
    if limit > 0.1 && limit < 1e3 { limit } else { 1.0 }
}

fn input(limits: [f64; 3], ends: [f64; 4]) -> SCurveInput {
    let constraints = SCurveConstraints { max_jerk: kept(limits[0]), max_acceleration: kept(limits[1]), max_velocity: kept(limits[2]) };
    let start_conditions = SCurveStartConditions { q0: ends[0], q1: ends[1], v0: ends[2], v1: ends[3] };
    SCurveInput { constraints, start_conditions }
}

pub fn times(limits: [f64; 3], ends: [f64; 4]) -> [f64; 6] {
    let input = input(limits, ends);
    let t = input.calc_intervals();
    [t.t_j1, t.t_j2, t.t_a, t.t_v, t.t_d, t.total_duration()]
}

pub fn along(limits: [f64; 3], ends: [f64; 4], t: f64) -> [f64; 4] {
    let input = input(limits, ends);
    let params = SCurveParameters::new(&input.calc_intervals(), &input);
    [eval_position(&params, t), eval_velocity(&params, t), eval_acceleration(&params, t), eval_jerk(&params, t)]
}
