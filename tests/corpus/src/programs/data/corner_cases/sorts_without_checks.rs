//! Sorting and looking for an order leave no check, so that an entry point that does may claim that it has no fault.

use bessemer::prelude::*;

/// The middle of the last five readings.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MiddleOfFive {
    window: [f64; 5],
}

#[component]
impl MiddleOfFive {
    /// Takes a reading, and gives the middle one.
    #[entry(infallible)]
    pub fn step(&mut self, reading: f64) -> f64 {
        for at in 0..4 {
            self.window[at] = self.window[at + 1];
        }
        self.window[4] = reading;
        let mut sorted = self.window;
        sorted.sort_by(|one, other| one.total_cmp(other));
        sorted[2]
    }

    /// The rank among integers.
    #[entry(infallible)]
    pub fn rank(&self, ranks: &[u16; 6]) -> u16 {
        let mut sorted = *ranks;
        sorted.sort_unstable();
        sorted[3]
    }

    /// Test that ranks are in order, and the sum of their differences.
    #[entry(infallible)]
    pub fn rises(&self, ranks: &[u16; 6], used: u8) -> (bool, u32) {
        let used = &ranks[..usize::from(used % 7)];
        (used.is_sorted(), climbed(used))
    }
}

/// The sum of the steps upwards: the index before one that a loop counts is below the length, too.
#[function]
fn climbed(ranks: &[u16]) -> u32 {
    let mut sum: u32 = 0;
    for at in 1..ranks.len() {
        sum = sum.wrapping_add(u32::from(ranks[at].saturating_sub(ranks[at - 1])));
    }
    sum
}
