//! A law that is made.
use bessemer::prelude::*;

#[function]
fn law(p: f64) -> impl Fn(f64) -> f64 {
    move |x| p * x
}

#[component]
#[derive(Default)]
pub struct FunctionThatReturnsAClosure {
    pub last: f64,
}

#[component]
impl FunctionThatReturnsAClosure {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = law(2.0)(x);
        self.last
    }
}
