//! An author's methods with the names of those of nalgebra's matrices and views.

use bessemer::prelude::*;

/// A table whose methods have the names of a matrix's.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Table {
    cells: [u32; 4],
}

#[data]
impl Table {
    /// The first cell that satisfies a closure.
    pub fn apply(&self, wanted: impl Fn(u32) -> bool) -> u32 {
        let mut found = 0;
        for cell in self.cells {
            if found == 0 && wanted(cell) {
                found = cell;
            }
        }
        found
    }

    /// A fold of the first and last cell, from the last.
    pub fn fold(&self, start: u32, join: impl Fn(u32, u32) -> u32) -> u32 {
        join(join(start, self.cells[3]), self.cells[0])
    }
}

/// Calls both methods.
#[function]
pub fn of_a_table(table: &Table, least: u32) -> (u32, u32) {
    (table.apply(|cell| cell > least), table.fold(least, |sum, cell| sum.wrapping_mul(3) ^ cell))
}

/// Applies a closure to the element at an index.
#[function(expand)]
fn of_one<F: FnMut(u32) -> u32>(values: &[u32; 4], at: usize, mut f: F) -> u32 {
    f(values[at])
}

/// The index is checked even if the closure ignores the element, and before the closure has side effects.
#[function]
pub fn unread(values: &[u32; 4], at: usize, calls: &mut u32) -> u32 {
    let first = of_one(values, at, |_| {
        *calls = calls.wrapping_add(1);
        7
    });
    first ^ of_one(values, at / 2, |_value| 9)
}
