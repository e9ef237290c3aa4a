//! Arrays of arrays are C arrays of several dimensions.

use bessemer::prelude::*;

/// The mean of the four neighbours of a point inside a map of heights.
#[function]
pub fn smoothed(heights: &[[f32; 5]; 4], row: usize, column: usize) -> f32 {
    assert!(row >= 1 && row <= 2 && column >= 1 && column <= 3);
    let sum = heights[row - 1][column]
        + heights[row + 1][column]
        + heights[row][column - 1]
        + heights[row][column + 1];
    sum / 4.0
}
