//! A helper in a module.
use bessemer::prelude::*;

mod tools {
    pub fn limit(x: f64) -> f64 {
        x.clamp(-1.0, 1.0)
    }
}

#[component]
#[derive(Default)]
pub struct ModuleHelper {
    pub last: f64,
}

#[component]
impl ModuleHelper {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = tools::limit(x);
        self.last
    }
}
