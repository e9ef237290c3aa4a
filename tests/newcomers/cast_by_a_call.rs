//! A conversion as in Python and C++.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct CastByACall {
    pub last: f64,
}

#[component]
impl CastByACall {
    #[entry]
    pub fn step(&mut self, n: u32) -> f64 {
        self.last = f64(n) * 0.5;
        self.last
    }
}
