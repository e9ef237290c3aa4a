//! A component with rollback, inside another component; its copy is too large for the stack.

use bessemer::prelude::*;

/// Counts occurrences at many positions.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Tally {
    /// Number of occurrences at each position.
    pub counts: [u32; 80],
}

impl Default for Tally {
    fn default() -> Self {
        Self { counts: [u32::MAX - 2; 80] }
    }
}

#[component]
impl Tally {
    /// Counts at some positions from the first on; a position out of range or a counter at its maximum is a fault.
    #[entry(atomic)]
    pub fn count(&mut self, from: u8, places: u8) -> u32 {
        let mut last = 0;
        for n in 0..(places as usize) {
            self.counts[from as usize + n] += 1;
            last = self.counts[from as usize + n];
        }
        last
    }
}

/// Two counting components.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pair {
    /// First component.
    pub one: Tally,
    /// Second component.
    pub other: Tally,
}

#[component]
impl Pair {
    /// Counts in both components.
    #[entry(atomic)]
    pub fn count(&mut self, from: u8, places: u8) -> u32 {
        self.one.count(from, places) ^ self.other.count(from, 1)
    }
}
