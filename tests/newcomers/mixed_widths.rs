//! Words of two widths.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MixedWidths {
    pub last: u16,
}

#[component]
impl MixedWidths {
    #[entry]
    pub fn step(&mut self, high: u16, low: u8) -> u16 {
        self.last = high << 8 | low;
        self.last
    }
}
