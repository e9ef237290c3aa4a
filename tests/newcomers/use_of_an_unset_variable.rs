//! A variable that is set in one branch.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct UseOfAnUnsetVariable {
    pub last: f64,
}

#[component]
impl UseOfAnUnsetVariable {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let y: f64;
        if x > 0.0 {
            y = x;
        }
        self.last = y;
        self.last
    }
}
