//! Component-wise operations on vectors are merged into one loop.

use bessemer::prelude::*;

/// A blend of two images of six points.
#[function]
pub fn blended(
    a: &SMatrix<f32, 6, 1>,
    b: &SMatrix<f32, 6, 1>,
    mask: &SMatrix<f32, 6, 1>,
) -> SMatrix<f32, 6, 1> {
    a + (b - a).component_mul(mask)
}
