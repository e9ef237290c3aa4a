//! Components of vectors by their names, in any order: `xy`, `zyx`.

use bessemer::prelude::*;

/// The distance in the plane, and the distance times the sine of the bearing.
#[function]
pub fn in_the_plane(from: &Vector3<f64>, to: &Vector3<f64>) -> (f64, f64) {
    let way = to.xy() - from.xy();
    (way.norm(), way.yx().x)
}

/// The position in a state, converted from north-east-down to east-north-up.
#[function]
pub fn turned(state: &SVector<f32, 6>) -> Vector3<f32> {
    let swapped = state.yxz();
    Vector3::new(swapped.x, swapped.y, -swapped.z)
}

/// Swizzle of a sum; the sum is computed once.
#[function]
pub fn of_a_sum(a: &Vector4<f64>, b: &Vector4<f64>) -> Vector3<f64> {
    (a + b).zzx() - a.xyz().zyx()
}

/// Swizzles of integers, and of a column of a matrix.
#[function]
pub fn of_others(a: &Vector2<i32>, m: &Matrix3<f64>) -> (Vector2<i32>, Vector2<f64>) {
    (a.yx(), m.column(1).xz())
}
