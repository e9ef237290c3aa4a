//! The items of a list without an attribute.
use bessemer::prelude::*;

#[derive(Clone, Copy, Default)]
pub struct Sample {
    pub value: f64,
}

#[component]
#[derive(Default)]
pub struct ForgotWhatAListHolds {
    pub last: f64,
}

#[component]
impl ForgotWhatAListHolds {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let mut list: List<Sample, 4> = List::default();
        list.push(Sample { value: x });
        self.last = list[0].value;
        self.last
    }
}
