//! A text for the display.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Formatting {
    pub last: f64,
}

#[component]
impl Formatting {
    #[entry]
    pub fn step(&mut self, x: f64) -> usize {
        self.last = x;
        let text = format!("{x:.1} V");
        text.len()
    }
}
