#![no_std]
use bessemer::prelude::*;

/// Reserved and taken type names.
#[data]
#[c(name = "int")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct One {
    #[c(name = "while")]
    pub a: f32,
    #[c(name = "c")]
    pub b: f32,
    pub c: f32,
}

#[data]
#[c(name = "gain_t")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Two {
    #[default]
    #[c(name = "errno")]
    A,
    #[c(name = "gain_t")]
    B,
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gain {
    pub a: f32,
}

#[data]
#[c(name = "bad_sum")]
const TABLE: [f32; 2] = [1.0, 2.0];

#[data]
#[c(name = "default")]
static OTHER: [f32; 2] = [1.0, 3.0];

#[function]
pub fn sum(#[c(name = "register")] x: f32, #[c(name = "z")] y: f32, z: f32) -> f32 {
    TABLE[0] + x + y + OTHER[1] + z
}
