//! `is_sorted` returns whether the elements of a slice are in order.

use bessemer::prelude::*;

/// The breakpoints of a table, and their number.
#[data]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Breakpoints {
    /// The breakpoints.
    pub at: [f64; 6],
    /// Number of breakpoints.
    pub count: u8,
}

/// Returns true if a table can be used. Its breakpoints must be in order, and none may be NaN.
#[function]
pub fn is_usable(table: &Breakpoints) -> bool {
    let count = usize::from(table.count).clamp(2, 6);
    table.at[..count].is_sorted()
}

/// Tests the order of lists, of pairs, and of an array with one element.
#[function]
pub fn ordered(n: u8, pairs: &[(u8, f32); 3]) -> [bool; 3] {
    let mut list: List<u8, 4> = List::new();
    for k in 0..n % 4 {
        list.push(k ^ 2);
    }
    [list.is_sorted(), pairs.is_sorted(), [n].is_sorted()]
}
