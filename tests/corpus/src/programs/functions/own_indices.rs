//! An author's own `[…]`: `Index` and `IndexMut` return references.

use core::ops::{Index, IndexMut};

use bessemer::prelude::*;

/// Heights on a grid, row by row.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Grid {
    heights: [f64; 12],
}

#[data]
impl Index<(usize, usize)> for Grid {
    type Output = f64;

    fn index(&self, (row, column): (usize, usize)) -> &f64 {
        assert!(column < 4);
        &self.heights[4 * row + column]
    }
}

#[data]
impl IndexMut<(usize, usize)> for Grid {
    fn index_mut(&mut self, (row, column): (usize, usize)) -> &mut f64 {
        assert!(column < 4);
        &mut self.heights[4 * row + column]
    }
}

/// Left or right.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    Left,
    Right,
}

/// A value for each side.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sides {
    left: i32,
    right: i32,
}

#[data]
impl Index<Side> for Sides {
    type Output = i32;

    fn index(&self, side: Side) -> &i32 {
        match side {
            Side::Left => &self.left,
            Side::Right => &self.right,
        }
    }
}

/// Sets a point to the mean of itself and its neighbour, and returns it.
#[function]
pub fn levelled(grid: &mut Grid, row: usize, column: usize) -> f64 {
    let mean = 0.5 * (grid[(row, column)] + grid[(row, column + 1)]);
    grid[(row, column)] = mean;
    grid[(0, 3)] += mean;
    mean
}

/// The difference of the two values.
#[function]
pub fn difference(sides: Sides) -> i32 {
    sides[Side::Left].wrapping_sub(sides[Side::Right])
}
