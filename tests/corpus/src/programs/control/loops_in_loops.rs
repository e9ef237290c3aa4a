//! Nested loops with bounds that depend on the outer one.

use bessemer::prelude::*;

/// Sorts five numbers (insertion by exchange).
#[function]
pub fn sorted(mut values: [i16; 5]) -> [i16; 5] {
    for end in 1..5 {
        for i in (0..end).rev() {
            if values[i] > values[i + 1] {
                let larger = values[i];
                values[i] = values[i + 1];
                values[i + 1] = larger;
            }
        }
    }
    values
}
