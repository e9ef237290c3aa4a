//! A struct that is only used inside.
use bessemer::prelude::*;

#[data]
struct Pair {
    a: f64,
    b: f64,
}

#[component]
#[derive(Default)]
pub struct UnmarkedWithin {
    pub last: f64,
}

#[component]
impl UnmarkedWithin {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let pair = Pair { a: x, b: 2.0 * x };
        self.last = pair.a + pair.b;
        self.last
    }
}
