//! `break` and `continue` may name an outer loop.

use bessemer::prelude::*;

/// Number of rows before the first row with a gap; a row ends with a 0.
#[function]
pub fn rows_without_gap(grid: &[[u8; 4]; 3]) -> u32 {
    let mut rows = 0;
    'rows: for row in grid {
        for cell in row {
            if *cell == 0 {
                rows += 1;
                continue 'rows;
            }
            if *cell == 255 {
                break 'rows;
            }
        }
        rows += 1;
    }
    rows
}
