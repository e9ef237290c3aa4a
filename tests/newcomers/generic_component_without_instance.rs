//! A filter for each float.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Lag<T> {
    pub state: T,
}

#[component]
impl<T: Real> Lag<T> {
    #[entry]
    pub fn step(&mut self, x: T) -> T {
        self.state = x;
        self.state
    }
}
