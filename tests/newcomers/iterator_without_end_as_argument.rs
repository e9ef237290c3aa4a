//! An iterator that nothing bounds, as the argument of a function with a loop.
use bessemer::prelude::*;

#[data]
#[derive(Clone)]
pub struct Samples {
    pub at: i16,
}

#[data]
impl Iterator for Samples {
    type Item = i16;

    fn next(&mut self) -> Option<i16> {
        self.at = self.at.wrapping_mul(5);
        Some(self.at)
    }
}

#[function]
fn mixed(samples: impl Iterator<Item = i16>) -> i16 {
    let mut mix = 7_i16;
    for sample in samples {
        mix = mix.wrapping_mul(3) ^ sample;
    }
    mix
}

#[function]
fn mixed_twice(samples: impl Iterator<Item = i16>) -> i16 {
    mixed(samples).wrapping_mul(2)
}

#[component]
#[derive(Default)]
pub struct IteratorWithoutEndAsArgument {
    pub at: i16,
}

#[component]
impl IteratorWithoutEndAsArgument {
    #[entry]
    pub fn step(&mut self) -> i16 {
        let samples = Samples { at: self.at };
        mixed_twice([1, 2].into_iter()) ^ mixed_twice(samples)
    }
}
