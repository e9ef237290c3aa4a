//! Three helpers, of which only the first has an attribute.
use bessemer::prelude::*;

#[function]
fn first(x: f64) -> f64 {
    second(x) + 1.0
}

fn second(x: f64) -> f64 {
    third(x) * 2.0
}

fn third(x: f64) -> f64 {
    x - 3.0
}

#[component]
#[derive(Default)]
pub struct ForgotTwoLevelsDown {
    pub last: f64,
}

#[component]
impl ForgotTwoLevelsDown {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = first(x);
        self.last
    }
}
