//! Operations that compilers change in fast modes, and that gcc fuses by default: `tests/tests/corpus/guards.rs`
//! compiles them with each such flag.

use bessemer::prelude::*;

/// A rotation in the plane: a difference and a sum of products.
#[function]
pub fn turned(x: f64, y: f64, cosine: f64, sine: f64) -> [f64; 2] {
    [x * cosine - y * sine, y * cosine + x * sine]
}

#[function]
pub fn turned_single(x: f32, y: f32, cosine: f32, sine: f32) -> [f32; 2] {
    [x * cosine - y * sine, y * cosine + x * sine]
}

/// Four rotations, which fill a vector register.
#[function]
pub fn turned_all(all: &mut [[f64; 2]; 4], cosine: f64, sine: f64) {
    for point in all.iter_mut() {
        *point = [point[0] * cosine - point[1] * sine, point[1] * cosine + point[0] * sine];
    }
}

/// Products of complex numbers, for which AArch64 has an instruction that gcc would use.
#[function]
pub fn multiplied(a: &[f64; 16], b: &[f64; 16]) -> [f64; 16] {
    let mut product = [0.0; 16];
    for i in 0..8 {
        product[2 * i] = a[2 * i] * b[2 * i] - a[2 * i + 1] * b[2 * i + 1];
        product[2 * i + 1] = a[2 * i] * b[2 * i + 1] + a[2 * i + 1] * b[2 * i];
    }
    product
}

#[function]
pub fn multiplied_single(a: &[f32; 16], b: &[f32; 16]) -> [f32; 16] {
    let mut product = [0.0; 16];
    for i in 0..8 {
        product[2 * i] = a[2 * i] * b[2 * i] - a[2 * i + 1] * b[2 * i + 1];
        product[2 * i + 1] = a[2 * i] * b[2 * i + 1] + a[2 * i + 1] * b[2 * i];
    }
    product
}

/// A loop that alternates between two operations.
#[function]
pub fn by_turns(a: &[f64; 32], b: &[f64; 32], c: &[f64; 32]) -> [f64; 32] {
    let mut result = [0.0; 32];
    for i in 0..16 {
        result[2 * i] = a[2 * i] * b[2 * i] - c[2 * i];
        result[2 * i + 1] = a[2 * i + 1] * b[2 * i + 1] + c[2 * i + 1];
    }
    result
}

/// A determinant and the elements next to it: products with both signs.
#[function]
pub fn inverted(m: Matrix2<f64>) -> Matrix2<f64> {
    let determinant = m[(0, 0)] * m[(1, 1)] - m[(0, 1)] * m[(1, 0)];
    let trace = m[(0, 0)] * m[(0, 0)] + m[(1, 1)] * m[(1, 1)];
    Matrix2::new(m[(1, 1)] / determinant, -m[(0, 1)] / determinant, trace, m[(0, 0)] / determinant)
}

/// Sums of products that would have one rounding less if they were fused.
#[function]
pub fn fused(a: f64, b: f64, c: f64) -> [f64; 3] {
    [a * b + c, a * b - c, c - a * b]
}

#[function]
pub fn fused_single(a: f32, b: f32, c: f32) -> [f32; 3] {
    [a * b + c, a * b - c, c - a * b]
}

/// Rounding error of a sum, which is zero in another order of operations.
#[function]
pub fn lost(a: f64, b: f64) -> f64 {
    let sum = a + b;
    let part = sum - a;
    (a - (sum - part)) + (b - part)
}

/// A sum in a fixed order.
#[function]
pub fn summed(list: &[f64; 16]) -> f64 {
    let mut sum = 0.0;
    for x in list {
        sum += *x;
    }
    sum
}

#[function]
pub fn summed_single(list: &[f32; 16]) -> f32 {
    let mut sum = 0.0;
    for x in list {
        sum += *x;
    }
    sum
}

/// Divisions by one number, which must not become multiplications by its reciprocal.
#[function]
pub fn shared(list: &[f64; 4], by: f64) -> [f64; 6] {
    [list[0] / by, list[1] / by, list[2] / by, list[3] / by, list[0] / 3.0, list[1] * 7.0 / 7.0]
}

/// Operations that depend on the signs of zeros.
#[function]
pub fn signs(a: f64, b: f64) -> [f64; 5] {
    [-(a - b), a + 0.0, a * 0.0, 0.0 - a, 1.0 / (a - a)]
}

/// Tests that a compiler would resolve if it assumed all numbers to be finite.
#[function]
pub fn asked(a: f64, b: f64) -> u32 {
    let equal = u32::from(a == a) + 2 * u32::from(a.is_nan()) + 4 * u32::from(b.is_infinite());
    let order = u32::from(a < b) + 2 * u32::from(!(a >= b)) + 4 * u32::from(a - a == 0.0);
    equal + 8 * order
}

/// Numbers that would be rounded twice in a wider register.
#[function]
pub fn narrow(a: f32, b: f32, c: f64) -> [f64; 3] {
    [f64::from(a * b - a), f64::from(a / b), f64::from((c * 0.1) as f32) * 0.1]
}
