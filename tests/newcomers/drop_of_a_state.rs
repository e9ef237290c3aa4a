//! Work when a value ends.
use bessemer::prelude::*;

#[data]
pub struct Guard {
    pub level: f64,
}

#[data]
impl Drop for Guard {
    fn drop(&mut self) {
        self.level = 0.0;
    }
}

#[component]
#[derive(Default)]
pub struct DropOfAState {
    pub last: f64,
}

#[component]
impl DropOfAState {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
