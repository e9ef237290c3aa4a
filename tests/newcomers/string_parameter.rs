//! A mode that is chosen by its name.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct NamedMode {
    pub last: f64,
}

#[component]
impl NamedMode {
    #[entry]
    pub fn step(&mut self, mode: &str) -> f64 {
        if mode == "fast" {
            self.last = 2.0;
        }
        self.last
    }
}
