//! Tests that squares ascend.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SortedBehindALink {
    pub last: bool,
}

#[component]
impl SortedBehindALink {
    #[entry]
    pub fn step(&mut self, samples: &[f64; 4]) -> bool {
        self.last = samples.iter().map(|x| x * x).is_sorted();
        self.last
    }
}
