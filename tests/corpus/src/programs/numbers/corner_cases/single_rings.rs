//! A ring in single precision whose index has 32 bits: no operation has 64, with or without the checks that were proved.

use bessemer::prelude::*;

/// Half the number of readings.
const HALF: usize = 4;

/// The last readings.
#[component]
#[derive(Default)]
pub struct SingleRing {
    /// Readings, the newest at `at`.
    pub values: [f32; 8],
    /// Index of the newest.
    pub at: u32,
}

#[component]
impl SingleRing {
    /// Stores a reading; the result is the oldest.
    #[entry(single)]
    pub fn step(&mut self, x: f32) -> f32 {
        self.at = (self.at + 1) % 8;
        self.values[self.at as usize] = x;
        self.values[((self.at + 1) % 8) as usize]
    }

    /// Moves the second half to the first: an index is the sum of a counter and a constant.
    #[entry(single)]
    pub fn halve(&mut self, x: f32) -> f32 {
        for i in 0..HALF {
            self.values[i] = self.values[i + HALF] + self.values[2 * HALF - 1 - i];
        }
        self.values[HALF] = x;
        self.values[0]
    }

    /// The reading some steps before the newest.
    #[entry(single)]
    pub fn before(&self, steps: u8) -> f32 {
        let at = (self.at % 8 + 8 - u32::from(steps % 8)) % 8;
        self.values[at as usize]
    }
}
