#![no_std]
extern crate std;

use bessemer::prelude::*;

/// nalgebra's own sine and cosine.
#[function]
pub fn rotation(x: f64, v: &Vector3<f64>) -> f64 {
    let turn = Matrix3::new_rotation(x);
    let same = bessemer::nalgebra::Rotation3::from_euler_angles(x, 0.0, 0.0);
    v.angle(v)
}

fn main() {}
