//! The good ones among the samples.
use bessemer::prelude::*;

#[function]
fn good(samples: &[f64; 4]) -> impl Iterator<Item = f64> {
    samples.iter().copied().filter(|x| *x > 0.0)
}

#[component]
#[derive(Default)]
pub struct FunctionThatReturnsAnIterator {
    pub last: f64,
}

#[component]
impl FunctionThatReturnsAnIterator {
    #[entry]
    pub fn step(&mut self, samples: &[f64; 4]) -> f64 {
        let good = good(samples);
        self.last = 0.0;
        for x in good {
            self.last += x;
        }
        self.last
    }
}
