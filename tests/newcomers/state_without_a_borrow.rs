//! A helper that changes a state.
use bessemer::prelude::*;

#[function]
fn advance(state: &mut f64) {
    *state += 1.0;
}

#[component]
#[derive(Default)]
pub struct StateWithoutABorrow {
    pub last: f64,
}

#[component]
impl StateWithoutABorrow {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        advance(self.last);
        self.last + x
    }
}
