//! Eight buttons debounced at once, with vertical counters of two bits.

use bessemer::prelude::*;

/// The bits of the counters, and the debounced state of the buttons.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Buttons {
    low: u8,
    high: u8,
    pressed: u8,
}

#[component]
impl Buttons {
    /// Takes one sample of all pins; returns the buttons that have just been pressed.
    #[entry(infallible)]
    pub fn step(&mut self, pins: u8) -> u8 {
        let changed = pins ^ self.pressed;
        // Counts 0, 1, 2, 3 for each pin that differs; back to 0 for the others.
        self.high = (self.high ^ self.low) & changed;
        self.low = !self.low & changed;
        let settled = changed & self.high & self.low;
        self.pressed ^= settled;
        settled & self.pressed
    }
}
