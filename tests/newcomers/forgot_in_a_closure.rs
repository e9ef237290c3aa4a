//! A helper without an attribute, called in a closure.
use bessemer::prelude::*;

fn halved(x: f64) -> f64 {
    0.5 * x
}

#[component]
#[derive(Default)]
pub struct ForgotInAClosure {
    pub last: f64,
}

#[component]
impl ForgotInAClosure {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let all = [x, 2.0 * x].map(|it| halved(it));
        self.last = all[0] + all[1];
        self.last
    }
}
