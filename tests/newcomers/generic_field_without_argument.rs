//! A filter as a field.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Lag<T> {
    pub state: T,
}

#[component]
#[derive(Default)]
pub struct GenericFieldWithoutArgument {
    pub lag: Lag,
}

#[component]
impl GenericFieldWithoutArgument {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.lag.state = x;
        self.lag.state
    }
}
