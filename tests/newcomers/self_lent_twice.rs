//! A field handed to a method of the same component.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SelfLentTwice {
    pub values: [f64; 4],
}

#[component]
impl SelfLentTwice {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.put(&mut self.values[0], x);
        self.values[0]
    }

    fn put(&mut self, place: &mut f64, x: f64) {
        *place = x;
        self.values[1] = x;
    }
}
