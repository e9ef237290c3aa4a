//! `#[derive(Default)]` of structs with long arrays, and conditional attributes that change nothing.

use bessemer::prelude::*;

/// Number of samples.
const COUNT: usize = 40;

/// A window over samples.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(any(), derive(Hash), must_use)]
pub struct Window {
    samples: [f64; COUNT],
    rows: [[i32; 2]; 33],
    marks: Marks<34>,
    at: usize,
}

/// Marks, as many as its user wants.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Marks<const N: usize> {
    #[cfg_attr(any(), allow(dead_code))]
    set: [bool; N],
}

#[component]
impl Window {
    /// Adds a sample.
    #[entry]
    pub fn add(&mut self, sample: f64) -> f64 {
        #[allow(clippy::deprecated_cfg_attr)]
        #[cfg_attr(rustfmt, rustfmt_skip)]
        let next = [1, 2,
            3];
        let oldest = self.samples[self.at];
        self.samples[self.at] = sample;
        self.at = (self.at + next[0]) % COUNT;
        self.rows[self.at % 33][1] += next[1] as i32;
        self.marks.set[self.at % 34] = true;
        oldest
    }
}
