//! The median of the last five samples, by insertion into a sorted copy.

use bessemer::prelude::*;

/// Number of samples in the window.
const WINDOW: usize = 5;

/// The last samples.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Median {
    samples: [i32; WINDOW],
    next: usize,
}

#[component]
impl Median {
    /// Takes a sample and returns the median of the window.
    #[entry]
    pub fn step(&mut self, sample: i32) -> i32 {
        self.samples[self.next] = sample;
        self.next = (self.next + 1) % WINDOW;
        let mut sorted = self.samples;
        for i in 1..WINDOW {
            let value = sorted[i];
            let mut at = i;
            #[bound(WINDOW)]
            while at > 0 && sorted[at - 1] > value {
                sorted[at] = sorted[at - 1];
                at -= 1;
            }
            sorted[at] = value;
        }
        sorted[WINDOW / 2]
    }
}
