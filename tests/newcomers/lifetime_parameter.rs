//! Two references, one of which is returned.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct LifetimeParameter {
    pub last: f64,
}

#[component]
impl LifetimeParameter {
    #[entry]
    pub fn step<'a>(&mut self, a: &'a f64, b: &'a f64) -> &'a f64 {
        self.last = *a;
        if *a > *b { a } else { b }
    }
}
