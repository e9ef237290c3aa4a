//! A filter within a component.
use bessemer::prelude::*;

#[data]
#[derive(Default)]
pub struct Filter {
    pub state: f64,
}

#[component]
#[derive(Default)]
pub struct UnmarkedField {
    pub filter: Filter,
}

#[component]
impl UnmarkedField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.filter.state += 0.1 * (x - self.filter.state);
        self.filter.state
    }
}
