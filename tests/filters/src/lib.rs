//! A library of filters, as an author may have one beside the models.
//!
//! `tests/corpus/src/programs/functions/other_crates.rs` uses it: only what is called comes along into the C, one file for each
//! module or component.

#![no_std]

use bessemer::prelude::*;

#[allow(hidden_glob_reexports)]
mod cossin;
pub mod quantities;
/// A module of its function's name that is written out.
pub mod turn {
    use bessemer::prelude::*;

    /// Returns a share of a turn, in rad.
    #[function]
    pub fn turn(share: f64) -> f64 {
        share * core::f64::consts::TAU
    }
}

#[allow(hidden_glob_reexports)]
pub use cossin::*;
pub use turn::*;

/// The largest input, V.
pub const LIMIT: f64 = 50.0;

/// A sensor's curve.
#[data]
pub static CURVE: [f64; 4] = [0.0, 1.0, 4.0, 9.0];

/// Health of a sensor.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Health {
    /// New values come.
    #[default]
    Good,
    /// None came for so many steps.
    Stale(u8),
}

/// Filters that take a value and return one.
#[interface]
pub trait Filter {
    /// A step.
    fn step(&mut self, input: f64) -> f64;
}

/// A low pass of first order.
#[component]
#[derive(Clone, Debug)]
pub struct LowPass {
    /// Output of the last step.
    #[unit("V")]
    pub output: f64,
    weight: f64,
}

impl Default for LowPass {
    fn default() -> Self {
        LowPass { output: 0.0, weight: 0.5 }
    }
}

#[component]
impl Filter for LowPass {
    fn step(&mut self, input: f64) -> f64 {
        self.output += self.weight * (input.clamp(-LIMIT, LIMIT) - self.output);
        self.output
    }
}

/// A delay of so many steps.
#[component]
#[derive(Clone, Debug)]
pub struct Delay<T: Real, const N: usize> {
    values: [T; N],
    next: usize,
}

impl<T: Real, const N: usize> Default for Delay<T, N> {
    fn default() -> Self {
        Delay { values: [T::ZERO; N], next: 0 }
    }
}

#[component]
impl<T: Real, const N: usize> Delay<T, N> {
    /// Appends a value and returns the one pushed `N` steps before.
    #[entry]
    pub fn push(&mut self, value: T) -> T {
        let old = self.values[self.next];
        self.values[self.next] = value;
        self.next = (self.next + 1) % N;
        old
    }
}

/// The curve between its points.
#[function]
pub fn interpolate(at: f64) -> f64 {
    let at = at.clamp(0.0, 2.999);
    let low = at as usize;
    CURVE[low] + (CURVE[low + 1] - CURVE[low]) * (at - low as f64)
}

/// The larger of two; the second where one is no number.
#[function]
pub fn larger<T: Real>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// Nobody calls it: it is not in the C.
#[function]
pub fn unused(x: f64) -> f64 {
    x + 1.0
}

/// Returns the point of the unit circle at a share of a turn.
#[function]
pub fn on_circle(share: f64) -> (f64, f64) {
    cossin(turn(share))
}
