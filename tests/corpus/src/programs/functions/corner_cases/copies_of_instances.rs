//! Copies of a function for closures, in each instance of the generic function that passes them: no instance uses
//! another's copy.

use bessemer::prelude::*;

/// The last values, and their median.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Middle<const N: usize> {
    /// The last values, the newest first.
    pub last: [f32; N],
}

impl<const N: usize> Default for Middle<N> {
    fn default() -> Self {
        Self { last: [0.0; N] }
    }
}

#[component]
impl<const N: usize> Middle<N> {
    /// Adds a value; returns the median.
    #[entry]
    pub fn step(&mut self, value: f32) -> f32 {
        self.last.rotate_right(1);
        self.last[0] = value;
        let mut sorted = self.last;
        sorted.sort_unstable_by(|a, b| a.total_cmp(b));
        sorted[N / 2]
    }
}

/// The median of some numbers, in a free function.
#[function]
fn middle<const N: usize>(values: &[f32; N]) -> f32 {
    let mut sorted = *values;
    sorted.sort_unstable_by(|a, b| b.total_cmp(a));
    sorted[N / 2]
}

/// Contains an instance of each size.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Middles {
    three: Middle<3>,
    five: Middle<5>,
}

#[component]
impl Middles {
    /// Adds a value to each; returns their medians.
    #[entry]
    pub fn step(&mut self, value: f32) -> [f32; 4] {
        let three = self.three.step(value);
        let five = self.five.step(value);
        [three, five, middle(&self.three.last), middle(&self.five.last)]
    }
}
