//! A case forgotten.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MatchNotExhaustive {
    pub last: f64,
}

#[component]
impl MatchNotExhaustive {
    #[entry]
    pub fn step(&mut self, gear: u8) -> f64 {
        self.last = match gear {
            0 => 0.0,
            1 => 3.5,
        };
        self.last
    }
}
