//! Sorting and `is_sorted` need no checks, so entry points that use them may be declared free of faults.

use bessemer::prelude::*;

/// The median of the last five readings.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MiddleOfFive {
    window: [f64; 5],
}

#[component]
impl MiddleOfFive {
    /// Takes a reading and returns the median.
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

    /// The rank of the median among integers.
    #[entry(infallible)]
    pub fn rank(&self, ranks: &[u16; 6]) -> u16 {
        let mut sorted = *ranks;
        sorted.sort_unstable();
        sorted[3]
    }

    /// Returns whether the ranks are sorted, and the sum of their differences.
    #[entry(infallible)]
    pub fn rises(&self, ranks: &[u16; 6], used: u8) -> (bool, u32) {
        let used = &ranks[..usize::from(used % 7)];
        (used.is_sorted(), climbed(used))
    }
}

/// The sum of the upward steps; the index minus one needs no check either.
#[function]
fn climbed(ranks: &[u16]) -> u32 {
    let mut sum: u32 = 0;
    for at in 1..ranks.len() {
        sum = sum.wrapping_add(u32::from(ranks[at].saturating_sub(ranks[at - 1])));
    }
    sum
}
