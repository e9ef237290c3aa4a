//! Two indices of one generic type.
use bessemer::prelude::*;
use core::ops::Index;

#[data]
#[derive(Clone, Debug)]
pub struct Grid<T, const N: usize> {
    cells: [[T; N]; N],
}

#[data]
impl<T: Copy, const N: usize> Index<usize> for Grid<T, N> {
    type Output = [T; N];
    fn index(&self, row: usize) -> &[T; N] {
        &self.cells[row]
    }
}

#[data]
impl<T: Copy, const N: usize> Index<(usize, usize)> for Grid<T, N> {
    type Output = T;
    fn index(&self, (row, column): (usize, usize)) -> &T {
        &self.cells[row][column]
    }
}

#[function]
pub fn two_generic_indices(grid: &Grid<f32, 3>) -> f32 {
    grid[(1, 2)] + grid[0][1]
}
