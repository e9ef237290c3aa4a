//! An author's own methods that are called as nalgebra's of matrices and views.

use bessemer::prelude::*;

/// A table whose methods have the names of a matrix's.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Table {
    cells: [u32; 4],
}

#[data]
impl Table {
    /// The first cell for which a closure holds.
    pub fn apply(&self, wanted: impl Fn(u32) -> bool) -> u32 {
        let mut found = 0;
        for cell in self.cells {
            if found == 0 && wanted(cell) {
                found = cell;
            }
        }
        found
    }

    /// What a closure makes of the ends, from the last.
    pub fn fold(&self, start: u32, join: impl Fn(u32, u32) -> u32) -> u32 {
        join(join(start, self.cells[3]), self.cells[0])
    }
}

/// Both.
#[function]
pub fn of_a_table(table: &Table, least: u32) -> (u32, u32) {
    (table.apply(|cell| cell > least), table.fold(least, |sum, cell| sum.wrapping_mul(3) ^ cell))
}
