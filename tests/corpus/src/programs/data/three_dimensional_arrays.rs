//! Arrays of three dimensions are C arrays of three dimensions.

use bessemer::prelude::*;

/// Number of occupied cells.
#[function]
pub fn taken(grid: &[[[bool; 4]; 3]; 2]) -> u32 {
    let mut count = 0;
    for layer in grid {
        for row in layer {
            for cell in row {
                if *cell {
                    count += 1;
                }
            }
        }
    }
    count
}
