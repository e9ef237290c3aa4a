//! A ring buffer of fixed size that overwrites the oldest sample when it is full.

use bessemer::prelude::*;

/// Capacity of the buffer.
const PLACES: usize = 8;

/// A sample with its time.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    pub time: u32,
    pub value: f32,
}

/// The buffer.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Buffer {
    samples: [Sample; PLACES],
    first: usize,
    count: usize,
    lost: u32,
}

#[component]
impl Buffer {
    /// Adds a sample; returns the number of samples in the buffer.
    #[entry]
    pub fn put(&mut self, sample: Sample) -> usize {
        let place = (self.first + self.count) % PLACES;
        self.samples[place] = sample;
        if self.count < PLACES {
            self.count += 1;
        } else {
            self.first = (self.first + 1) % PLACES;
            self.lost = self.lost.saturating_add(1);
        }
        self.count
    }

    /// Removes the oldest sample into `sample`; returns false if the buffer is empty.
    #[entry]
    pub fn take(&mut self, sample: &mut Sample) -> bool {
        if self.count == 0 {
            return false;
        }
        *sample = self.samples[self.first];
        self.first = (self.first + 1) % PLACES;
        self.count -= 1;
        true
    }
}
