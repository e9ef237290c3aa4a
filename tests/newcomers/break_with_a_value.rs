//! The first element above a limit.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct BreakWithAValue {
    pub values: [f64; 3],
}

#[component]
impl BreakWithAValue {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let found = for i in 0..3 {
            if self.values[i] > x {
                break i;
            }
        };
        self.values[found]
    }
}
