#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A struct with a place to borrow.
#[component]
#[derive(Default)]
pub struct Samples {
    values: [f64; 2],
}

#[component]
impl Samples {
    /// To the firmware.
    #[entry]
    pub fn first(&self) -> &f64 {
        &self.values[0]
    }

    /// Early.
    fn either(&self, i: usize) -> &f64 {
        if i > 1 {
            return &self.values[1];
        }
        &self.values[i]
    }

    /// Without a length.
    fn some(&self, n: usize) -> &[f64] {
        &self.values[..n]
    }

    /// By way of a closure.
    fn chosen(&self, choose: impl Fn(usize) -> usize) -> &f64 {
        &self.values[choose(0)]
    }
}

fn main() {}
