//! Sorting leaves no check, so that an entry point that sorts may claim that it has no fault.

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

    /// The same of ranks, which are integers.
    #[entry(infallible)]
    pub fn rank(&self, ranks: &[u16; 6]) -> u16 {
        let mut sorted = *ranks;
        sorted.sort_unstable();
        sorted[3]
    }
}
