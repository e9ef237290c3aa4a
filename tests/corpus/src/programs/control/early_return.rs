//! A function may return from any position.

use bessemer::prelude::*;

/// The index of `wanted` in a sorted table, or the table's length.
#[function]
pub fn search(table: &[u16; 8], wanted: u16) -> usize {
    let (mut low, mut high) = (0, 8);
    #[bound(4)]
    while low < high {
        let middle = (low + high) / 2;
        if table[middle] == wanted {
            return middle;
        }
        if table[middle] < wanted {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    8
}
