//! Calls of `micromath` over plain numbers. A call `x.sin()` of an `f32` would be the number's own method, not the crate's.

use crate::{F32, F32Ext};

pub fn trigonometry(x: f32, y: f32) -> [f32; 8] {
    let a = F32(x);
    let (sin, cos) = a.sin_cos();
    [a.sin().0, a.cos().0, a.tan().0, a.atan().0, a.atan2(F32(y)).0, a.asin().0, sin.0, cos.0]
}

pub fn logarithms(x: f32, base: f32) -> [f32; 5] {
    let a = F32(x);
    [a.exp().0, a.ln().0, a.log(F32(base)).0, a.log2().0, a.log10().0]
}

pub fn powers(x: f32, y: f32, n: i32) -> [f32; 5] {
    let (a, b) = (F32(x), F32(y));
    [a.powf(b).0, a.powi(n).0, a.sqrt().0, x.invsqrt(), a.hypot(b).0]
}

pub fn parts(x: f32, y: f32, z: f32) -> [f32; 11] {
    let (a, b) = (F32(x), F32(y));
    [
        a.abs().0,
        a.ceil().0,
        a.floor().0,
        a.round().0,
        a.trunc().0,
        a.fract().0,
        a.signum().0,
        a.copysign(b).0,
        a.mul_add(b, F32(z)).0,
        a.div_euclid(b).0,
        a.rem_euclid(b).0,
    ]
}

pub fn operators(x: f32, y: f32) -> [f32; 6] {
    let (a, b) = (F32(x), F32(y));
    [(a + b).0, (a - b).0, (a * b).0, (a / b).0, (-a).0, a.inv().0]
}
