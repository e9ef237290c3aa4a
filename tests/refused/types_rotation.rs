#![no_std]
extern crate std;

use bessemer::nalgebra::UnitComplex;
use bessemer::prelude::*;

/// nalgebra's own sine and cosine.
#[function]
pub fn rotation(x: f64, v: &Vector3<f64>) -> f64 {
    let turn = Matrix3::new_rotation(x);
    let same = bessemer::nalgebra::Rotation3::from_euler_angles(x, 0.0, 0.0);
    let q = UnitQuaternion::new(*v);
    let (roll, pitch, yaw) = q.euler_angles();
    v.angle(v)
}

/// Not one of those that there are.
#[function]
pub fn plane(turn: UnitComplex<f64>) -> f64 {
    turn.re
}

fn main() {}
