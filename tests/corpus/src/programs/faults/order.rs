//! Effects before a fault stay; nothing after it happens. A component that has faulted stays so until `init`.

use bessemer::prelude::*;

/// A ring of measurements.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ring {
    values: [f32; 4],
    next: usize,
    taken: u8,
}

#[component]
impl Ring {
    /// Takes a value into the slot that the caller skips to.
    #[entry]
    pub fn take(&mut self, value: f32, skip: usize) -> u8 {
        self.taken += 1;
        self.values[self.next + skip] = value;
        self.next = (self.next + skip + 1) % 4;
        self.taken
    }
}
