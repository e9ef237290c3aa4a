//! `break` and `continue` of outer loops.

use bessemer::prelude::*;

/// Searches a table for a value.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Search {
    /// The table.
    pub table: [[i32; 4]; 3],
}

impl Default for Search {
    fn default() -> Self {
        Search { table: [[1, 2, 3, 4], [5, -1, 7, 8], [9, 10, 11, 2]] }
    }
}

#[component]
impl Search {
    /// Position of a value; a negative number ends the search of its row.
    #[entry]
    pub fn run(&mut self, wanted: i32, replacement: i32) -> i32 {
        let mut found = -1;
        let mut seen = 0;
        'rows: for row in 0..3 {
            for column in 0..4 {
                let value = self.table[row][column];
                if value < 0 {
                    continue 'rows;
                }
                if value == wanted {
                    found = (row * 4 + column) as i32;
                    self.table[row][column] = replacement;
                    break 'rows;
                }
                seen += 1;
            }
            // Only whole rows count.
            seen += 100;
        }
        found * 1000 + seen
    }
}

/// Three nested loops, with every jump between them.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Deep {
    /// The trace of the last run.
    pub trace: u64,
}

#[component]
impl Deep {
    /// Leaves the loops as `how` and `when` select.
    #[entry]
    pub fn run(&mut self, how: u8, when: u8) -> u64 {
        let mut steps = 0;
        self.trace = 0;
        'outer: for i in 0..3_u8 {
            'middle: for j in (0..3_u8).rev() {
                for k in 0..=2_u8 {
                    steps += 1;
                    self.trace = self.trace.wrapping_mul(31).wrapping_add(steps);
                    if i + j + k == when {
                        match how {
                            0 => break,
                            1 => continue,
                            2 => break 'middle,
                            3 => continue 'middle,
                            4 => break 'outer,
                            5 => continue 'outer,
                            6 => return self.trace,
                            _ => {}
                        }
                    }
                }
                self.trace = self.trace.wrapping_add(1_000);
            }
            self.trace = self.trace.wrapping_add(1_000_000);
        }
        steps
    }
}
