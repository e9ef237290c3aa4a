//! Methods that a type of Rust's or nalgebra's has, or that is generic, with what to write in their place.
#![no_std]
use bessemer::prelude::*;

/// A generic median.
#[function]
pub fn median<T: Ord + Copy>(a: T, b: T, c: T) -> T {
    a.max(b).min(c)
}

/// The inverse of a matrix by nalgebra, and the decomposition by the DSL.
#[function]
pub fn inverted(a: &Matrix3x2<f64>) -> Matrix2x3<f64> {
    a.pseudo_inverse(1e-9).unwrap()
}

/// Roots of numbers.
#[function]
pub fn roots(x: u32, y: f64) -> f64 {
    f64::from(x.isqrt() + x.saturating_pow(2)) + y.midpoint(7.0)
}

/// Bytes in the target's own order, the last elements first, a copy on the heap, an order of parts.
#[function]
pub fn of_slices(n: u32, samples: &[u16; 4]) -> bool {
    let mut sum = n.max(n.to_be());
    for pair in samples.rchunks(2) {
        sum += u32::from(pair[0]);
    }
    let kept = samples.to_vec();
    samples.is_sorted_by(|a, b| a < b) && kept.len() > sum as usize
}

/// Decompositions that iterate without a bound, or ask the platform.
#[function]
pub fn decompositions(a: Matrix4<f64>) -> f64 {
    let eigen = a.symmetric_eigen();
    let values = a.svd(true, true).singular_values;
    let factors = a.full_piv_lu();
    eigen.eigenvalues[0] + values[0] + factors.determinant()
}

/// Constructors of nalgebra that use the platform's sine and cosine, or an iterator.
#[function]
pub fn constructors(v: Vector3<f64>) -> f64 {
    let turned = Rotation3::face_towards(&v, &Vector3::y());
    let list = Vector3::from_iterator([1.0, 2.0, 3.0]);
    let turn = Matrix3::new_rotation(v.x);
    turned[(0, 0)] + list[0] + turn[(0, 0)] + v.angle(&v) + f64::asinh(v.x)
}

/// As many rows as a number says.
#[function]
pub fn column(m: &mut Matrix3<f64>, j: usize) {
    let rows = m.rows(0, j);
    m[(0, 0)] = rows[(0, 0)];
}

/// An author's own methods of such names.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Chart {
    /// Position.
    pub at: f64,
}

#[data]
impl Chart {
    /// As seen from there.
    pub fn view(&self, row: f64, column: f64) -> f64 {
        self.at + row - column
    }

    /// Its bearing.
    pub fn angle(&self, other: f64) -> f64 {
        self.at - other
    }
}

/// They are the author's.
#[function]
pub fn own(chart: &Chart) -> f64 {
    chart.view(1.0, 2.0) + chart.angle(3.0)
}

#[allow(non_upper_case_globals)]
const limit: f64 = 2.0;

/// A constant of small letters, as what could be a function.
#[function]
pub fn limited(x: f64) -> f64 {
    x.max(1.0).min(limit)
}
