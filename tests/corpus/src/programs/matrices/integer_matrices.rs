//! Matrices of integers: arithmetic is checked for each element; methods that fill, swap and copy work as for floats.

use bessemer::prelude::*;

/// Sums, differences, and multiples.
#[function]
pub fn corrected(counts: &Matrix2<i32>, offsets: &Matrix2<i32>, gain: i32) -> Matrix2<i32> {
    (counts - offsets) * gain + Matrix2::identity()
}

/// A product adds its terms in order.
#[function]
pub fn mixed(weights: &Matrix2x3<i16>, levels: &Vector3<i16>) -> Vector2<i16> {
    weights * levels
}

/// Divides element by element, and by a number.
#[function]
pub fn shares(parts: &Vector3<u8>, wholes: &Vector3<u8>, divisor: u8) -> Vector3<u8> {
    parts.component_div(wholes) + parts.component_mul(wholes) / divisor
}

/// Negates a matrix in place.
#[function]
pub fn turned(grid: &mut Matrix3<i8>) {
    *grid = -*grid;
    *grid += Matrix3::from_diagonal_element(1);
}

/// Clears a row of a map of 4 by 4 cells.
#[function]
pub fn cleared(map: &mut Matrix4<u8>, row: usize) {
    map.fill_row(row, 9);
    map.swap_columns(0, 3);
    map.fill_lower_triangle(7, 2);
    map.set_diagonal(&Vector4::new(1, 2, 3, 4));
    map.transpose_mut();
}

/// Sum, minimum, maximum and trace.
#[function]
pub fn summary(map: &Matrix3<i32>) -> (i32, i32, i32, i32) {
    (map.sum(), map.max(), map.min(), map.trace())
}

/// Sums of rows and columns, of unsigned numbers.
#[function]
pub fn edges(map: &Matrix2x3<u16>) -> (RowVector3<u16>, Vector2<u16>) {
    (map.row_sum(), map.column_sum())
}

/// A matrix of `bool`.
#[function]
pub fn flagged(flags: &mut Matrix2<bool>) -> Matrix2<bool> {
    flags.swap((0, 0), (1, 1));
    let before = *flags;
    flags.fill_diagonal(true);
    before
}
