//! Calls of `micromath` over plain numbers.

use crate::{F32, F32Ext};

pub fn trigonometry(x: f32, y: f32) -> [f32; 8] {
    let (sin, cos) = x.sin_cos();
    [x.sin(), x.cos(), x.tan(), x.atan(), x.atan2(y), x.asin(), sin, cos]
}

pub fn logarithms(x: f32, base: f32) -> [f32; 5] {
    [x.exp(), x.ln(), x.log(base), x.log2(), x.log10()]
}

pub fn powers(x: f32, y: f32, n: i32) -> [f32; 5] {
    [x.powf(y), x.powi(n), x.sqrt(), x.invsqrt(), x.hypot(y)]
}

pub fn parts(x: f32, y: f32, z: f32) -> [f32; 11] {
    [
        x.abs(),
        x.ceil(),
        x.floor(),
        x.round(),
        x.trunc(),
        x.fract(),
        x.signum(),
        x.copysign(y),
        x.mul_add(y, z),
        x.div_euclid(y),
        x.rem_euclid(y),
    ]
}

pub fn operators(x: f32, y: f32) -> [f32; 6] {
    let (a, b) = (F32(x), F32(y));
    [(a + b).0, (a - b).0, (a * b).0, (a / b).0, (-a).0, a.inv().0]
}
