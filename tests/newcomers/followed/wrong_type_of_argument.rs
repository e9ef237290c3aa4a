//! An integer where a float belongs.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct WrongTypeOfArgument {
    pub last: f64,
}

#[component]
impl WrongTypeOfArgument {
    #[entry]
    pub fn step(&mut self, count: u32) -> f64 {
        self.last = 0.5 * f64::from(count);
        self.last
    }
}
