//! Calls of `advanced-pid` over plain numbers.

use crate::prelude::*;
use crate::*;

fn config(gains: [f32; 3], limits: [f32; 2]) -> PidConfig {
    PidConfig::new(gains[0], gains[1], gains[2]).with_limits(limits[0], limits[1])
}

pub fn standard(gains: [f32; 3], limits: [f32; 2], targets: [f32; 4], actual: [f32; 4], dt: f32) -> [f32; 4] {
    let mut pid = Pid::new(config(gains, limits));
    let mut out = [0.0; 4];
    for k in 0..4 {
        out[k] = pid.update(targets[k], actual[k], dt);
    }
    out
}

pub fn unlimited(kp: f32, ki: f32, kd: f32, target: f32, actual: f32, dt: f32) -> f32 {
    let gain = PidGain { kp, ki, kd };
    let mut pid = Pid::new(gain.into());
    pid.update(target, actual, dt)
}

pub fn velocity(gains: [f32; 3], limits: [f32; 2], targets: [f32; 4], actual: [f32; 4], dt: f32) -> [f32; 4] {
    let mut pid = VelPid::new(config(gains, limits));
    let mut out = [0.0; 4];
    for k in 0..4 {
        out[k] = pid.update(targets[k], actual[k], dt);
    }
    out
}

pub fn pi_d(gains: [f32; 3], limits: [f32; 2], targets: [f32; 4], actual: [f32; 4], dt: f32) -> [f32; 4] {
    let mut pid = PiD::new(config(gains, limits));
    let mut out = [0.0; 4];
    for k in 0..4 {
        out[k] = pid.update(targets[k], actual[k], dt);
    }
    out
}

pub fn i_pd(gains: [f32; 3], limits: [f32; 2], targets: [f32; 4], actual: [f32; 4], dt: f32) -> [f32; 4] {
    let mut pid = Ipd::default();
    pid.reset_config(config(gains, limits));
    let mut out = [0.0; 4];
    for k in 0..4 {
        out[k] = pid.update(targets[k], actual[k], dt);
    }
    out
}
