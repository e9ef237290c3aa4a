//! A number from a text.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ParsedText {
    pub last: f64,
}

#[component]
impl ParsedText {
    #[entry]
    pub fn step(&mut self, text: &str) -> f64 {
        self.last = text.parse().unwrap_or(0.0);
        self.last
    }
}
