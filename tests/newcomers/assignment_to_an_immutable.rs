//! A sum that is not `mut`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct AssignmentToAnImmutable {
    pub last: f64,
}

#[component]
impl AssignmentToAnImmutable {
    #[entry]
    pub fn step(&mut self, samples: &[f64; 4]) -> f64 {
        let sum = 0.0;
        for x in samples {
            sum += x;
        }
        self.last = sum;
        self.last
    }
}
