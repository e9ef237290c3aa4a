//! Effects before a fault remain; nothing is executed after it. A component in the fault state stays in it until
//! `init`.

use bessemer::prelude::*;

/// A ring buffer of measurements.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ring {
    values: [f32; 4],
    next: usize,
    taken: u8,
}

#[component]
impl Ring {
    /// Stores a value at a position relative to the last.
    #[entry]
    pub fn take(&mut self, value: f32, skip: usize) -> u8 {
        self.taken += 1;
        self.values[self.next + skip] = value;
        self.next = (self.next + skip + 1) % 4;
        self.taken
    }
}
