//! A case.
#![no_std]
use bessemer::prelude::*;

/// A smooth value.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Smooth {
    /// The last values.
    pub values: [f32; 8],
    /// Index of the next.
    pub next: usize,
}

#[component]
impl Smooth {
    /// Has a constant in double, a sine that computes so, and a count of 64 bits.
    #[entry(infallible, single)]
    pub fn step(&mut self, value: f32) -> f32 {
        let turned = value.sin();
        self.values[self.next % 8] = halved(turned);
        self.next = self.next.wrapping_add(1);
        self.values[0]
    }

    /// Nobody asked this one to be single.
    #[entry(infallible)]
    pub fn wide(&self, value: f64) -> f64 {
        value * 2.0
    }
}

/// Half of it.
#[function]
fn halved(value: f32) -> f32 {
    (value as f64 * 0.5) as f32
}
