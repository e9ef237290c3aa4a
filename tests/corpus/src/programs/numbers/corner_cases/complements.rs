//! Comparisons that gcc takes for ones of a complement, and would warn of.

use bessemer::prelude::*;

/// Complements of a byte, compared.
#[function]
pub fn left(x: u8, y: u8) -> (bool, bool, bool) {
    (u8::MAX - x < y, 255 - x == y, y >= u8::MAX - x)
}

/// Complements in 16 bits, and with constants.
#[function]
pub fn wide(x: u16, y: u16) -> (bool, bool, bool) {
    (u16::MAX - x > y, 65535 - x != 7, u16::MAX - x <= 9)
}

/// Complements and exclusive ors.
#[function]
pub fn bits(x: u8, y: u16) -> (bool, bool, bool, bool) {
    (!x < 7, !y == 9, x ^ 0xff > 3, y ^ u16::MAX < !y)
}

/// Complements after other arithmetic, and wrapped.
#[function]
pub fn wrapped(x: u8, y: u8) -> (bool, bool, bool) {
    let sum = x / 2 + y / 2;
    (255 - sum < y, 255u8.wrapping_sub(x) < y, !(x ^ y) == y)
}

/// A complement as a loop's bound, and as an index.
#[function]
pub fn counted(from: u8, table: &[u8; 4]) -> u32 {
    let mut count = 0;
    for i in from..u8::MAX - from {
        if !i < 100 && usize::from(!i) < 4 {
            count += u32::from(table[usize::from(!i)]);
        }
    }
    count
}

/// An author's type with the name of one in core.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    pub voltage: u16,
}

/// Returns true if the cell is full.
#[function]
pub fn full(cell: &Cell) -> bool {
    u16::MAX - cell.voltage < 5
}

/// Complements of widened values.
#[function]
pub fn widened(a: u8, b: u16, flag: bool) -> (bool, bool, bool, bool) {
    let most = !(flag as u64) >= 6;
    (!(a as u64) < b as u64, !(b as u32) > a as u32, most, !(a as usize) == 3)
}
