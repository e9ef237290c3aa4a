//! An author's own methods keep their meaning where slices and floats have methods of the same names.

use bessemer::prelude::*;

/// A bank of a few numbers.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bank {
    pub cells: [u8; 4],
}

/// The error for a missing value.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Missing {
    pub index: u8,
}

#[data]
impl Bank {
    fn get_mut(&mut self, index: u8) -> Result<u8, Missing> {
        if index >= 4 {
            return Err(Missing { index });
        }
        let cell = usize::from(index);
        self.cells[cell] = self.cells[cell].wrapping_add(1);
        Ok(self.cells[cell])
    }

    fn first_mut(&self) -> Option<u8> {
        (self.cells[0] > 7).then_some(self.cells[0])
    }

    fn swap(&mut self, by: u8) -> u8 {
        self.cells[0] ^= by;
        self.cells[0]
    }

    fn sort(&self) -> u8 {
        self.cells[3]
    }

    fn chunks(&self, size: u8) -> u8 {
        self.cells[1].wrapping_mul(size)
    }

    fn total_cmp(&self, other: &Bank) -> bool {
        self.cells[2] > other.cells[2]
    }
}

/// Calls the author's methods.
#[function]
pub fn use_all(bank: &mut Bank, index: u8) -> Result<u8, Missing> {
    let cell = bank.get_mut(index)?;
    let other = *bank;
    let mut sum = cell.wrapping_add(bank.swap(3)).wrapping_add(bank.sort());
    if Bank::total_cmp(bank, &other) {
        sum = sum.wrapping_add(Bank::chunks(bank, 5));
    }
    Ok(sum)
}

/// The first cell, if it is above a limit.
#[function]
pub fn much(bank: &Bank) -> Option<u8> {
    let first = bank.first_mut()?;
    Some(first.wrapping_add(1))
}

/// A destructured parameter that is written.
#[function]
pub fn turn([x, y]: &mut [f64; 2], (mut turns, by): (u8, f64)) -> u8 {
    core::mem::swap(x, y);
    *y = by - *y;
    turns = turns.wrapping_add(1);
    turns
}

/// Returns the value at an index and stores another; the index is read before it advances.
#[function]
pub fn taken(ring: &mut [u8; 4], at: usize, by: u8) -> u8 {
    core::mem::replace(&mut ring[at], 200 / by)
}

/// Stores a value after the index has advanced.
#[function]
pub fn moved_on(ring: &mut [u8; 4], start: u8) -> (u8, u8) {
    let mut at = usize::from(start % 3);
    let before = core::mem::replace(&mut ring[at], {
        at += 1;
        start / 2
    });
    (before, ring[at])
}
