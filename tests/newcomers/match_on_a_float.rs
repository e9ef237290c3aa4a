//! A case for standing still.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MatchOnAFloat {
    pub last: f64,
}

#[component]
impl MatchOnAFloat {
    #[entry]
    pub fn step(&mut self, speed: f64) -> f64 {
        self.last = match speed {
            0.0 => 0.0,
            1.0..=2.0 => 1.0,
            _ => 2.0,
        };
        self.last
    }
}
