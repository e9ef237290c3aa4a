//! An error of any kind.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct BoxedError {
    pub last: f64,
}

#[component]
impl BoxedError {
    #[entry]
    pub fn step(&mut self, x: f64) -> Result<f64, Box<dyn std::error::Error>> {
        self.last = x;
        Ok(self.last)
    }
}
