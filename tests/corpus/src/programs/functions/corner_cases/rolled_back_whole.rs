//! A component whose copy, for rolling back, is too large for the stack, within another one.

use bessemer::prelude::*;

/// Counts in many places.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Tally {
    /// Number of occurrences of each.
    pub counts: [u32; 80],
}

impl Default for Tally {
    fn default() -> Self {
        Self { counts: [u32::MAX - 2; 80] }
    }
}

#[component]
impl Tally {
    /// Counts from a place on; past the end, and at the largest count, it is a fault.
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

/// Two of them.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pair {
    /// The one.
    pub one: Tally,
    /// The other.
    pub other: Tally,
}

#[component]
impl Pair {
    /// Counts in both.
    #[entry(atomic)]
    pub fn count(&mut self, from: u8, places: u8) -> u32 {
        self.one.count(from, places) ^ self.other.count(from, 1)
    }
}
