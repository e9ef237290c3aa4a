//! A generic struct without an attribute.
use bessemer::prelude::*;

#[derive(Clone, Copy, Default)]
pub struct Lag<T> {
    pub state: T,
}

#[component]
#[derive(Default)]
pub struct ForgotAGenericStruct {
    pub lag: Lag<f64>,
}

#[component]
impl ForgotAGenericStruct {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.lag.state += 0.1 * (x - self.lag.state);
        self.lag.state
    }
}
