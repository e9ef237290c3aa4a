//! Ranges of parameters that are clamped or reported where the function begins.

use bessemer::prelude::*;

/// A valve.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Valve {
    opening: f32,
}

#[data]
impl Valve {
    /// Opens by a share.
    fn open(&mut self, #[range(0.0..=1.0, clamp)] share: f32) -> f32 {
        self.opening += share * (1.0 - self.opening);
        self.opening
    }

    /// Closes by a share.
    fn close(&mut self, #[range(0.0..=1.0, report)] share: f32) -> f32 {
        self.opening *= 1.0 - share;
        self.opening
    }
}

/// A law with a range of its own.
#[interface]
trait Law {
    fn answer(&self, error: f64) -> f64;

    /// Answers an error within bounds.
    fn bounded(&self, #[range(-2.0..=2.0, clamp)] error: f64) -> f64 {
        self.answer(error)
    }
}

#[data]
impl Law for Valve {
    fn answer(&self, #[range(-1..=3, clamp)] error: f64) -> f64 {
        error * 2.0
    }
}

#[function]
pub fn opened(#[range(-8..=8, clamp)] mut count: i8, share: f32) -> (i8, f32) {
    let mut valve = Valve::default();
    let opening = valve.open(share);
    count /= 2;
    (count, opening)
}

#[function]
pub fn closed(#[range(1..=250, report)] count: u8, share: f32) -> (u8, f32) {
    let mut valve = Valve { opening: 0.5 };
    (count - 1, valve.close(share))
}

#[function]
pub fn answered(error: f64) -> (f64, f64) {
    let valve = Valve::default();
    (valve.answer(error), valve.bounded(error))
}

/// Evaluates each argument once; a fault of one comes first.
#[function]
pub fn in_order(x: u8, by: u8) -> u8 {
    limited(x / by, 100 / by)
}

#[function]
fn limited(#[range(2..=20, clamp)] one: u8, #[range(0..=50, report)] other: u8) -> u8 {
    one + other
}
