#![no_std]
extern crate std;

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    Idle,
    Busy,
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, State)]
pub enum Choice {
    #[default]
    Only,
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq, State)]
pub struct Pair(f64, f64);

#[data]
#[derive(Clone, Copy, Debug, PartialEq, State)]
pub struct Nothing {}

#[data]
#[derive(Clone, Copy, Debug, PartialEq, State)]
pub struct Table {
    values: [f64; 3],
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq, State)]
pub struct Square {
    covariance: SMatrix<f64, 3, 3>,
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq, State)]
pub struct Turned {
    rotation: Rotation3<f64>,
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq, State)]
pub struct Mixed {
    place: Vector3<f64>,
    bias: f32,
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq, State)]
pub struct WithMode {
    place: f64,
    mode: Mode,
}

fn main() {}
