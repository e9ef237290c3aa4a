//! Named references to elements whose index changes afterwards, is a parameter, a loop's counter, or is never used.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    pub values: [i16; 3],
    pub log: List<u8, 2>,
}

/// The index changes after the reference is taken.
#[function]
pub fn moving(cells: &mut [Cell; 3], at: usize) -> usize {
    let mut i = at;
    let cell = &mut cells[i];
    i += 1;
    cell.values[0] = 7;
    let value = &mut cell.values[i % 4];
    i += 1;
    *value = -*value;
    i
}

/// An unused reference, whose index is checked nevertheless.
#[function]
pub fn looked(cells: &[Cell; 3], at: usize) -> u8 {
    let _cell = &cells[at];
    3
}

/// References in a loop, and into a list.
#[function]
pub fn summed(cells: &mut [Cell; 3], at: usize) -> i32 {
    let mut sum = 0;
    for i in 0..3 {
        let cell = &mut cells[i];
        cell.values[i] = cell.values[i].wrapping_add(1);
        sum += i32::from(cell.values[i]);
        let entry = &mut cell.log[at];
        *entry = entry.wrapping_add(1);
    }
    sum
}

/// A reference to an element of a matrix.
#[function]
pub fn doubled(m: &mut Matrix3<f64>, row: usize, column: usize) -> f64 {
    let element = &mut m[(row, column)];
    *element *= 2.0;
    *element + 1.0
}
