//! Calls of `pid` over plain numbers.

use crate::*;

pub fn of_f32(target: f32, limit: f32, gains: [f32; 3], limits: [f32; 3], measured: [f32; 6]) -> [f32; 6] {
    let mut pid = Pid::<f32>::new(target, limit);
    pid.p(gains[0], limits[0]).i(gains[1], limits[1]).d(gains[2], limits[2]);
    let mut out = [0.0; 6];
    for k in 0..6 {
        out[k] = pid.next_control_output(measured[k]).output;
    }
    out
}

pub fn terms_of_f64(target: f64, gains: [f64; 3], limits: [f64; 3], measured: [f64; 4], next: f64) -> [f64; 4] {
    let mut pid = Pid::<f64>::new(0.0, 100.0);
    pid.setpoint(target);
    pid.p(gains[0], limits[0]);
    pid.i(gains[1], limits[1]);
    pid.d(gains[2], limits[2]);
    for k in 0..4 {
        pid.next_control_output(measured[k]);
    }
    pid.reset_integral_term();
    let last = pid.next_control_output(next);
    [last.p, last.i, last.d, last.output]
}
