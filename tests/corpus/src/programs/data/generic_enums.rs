//! Enums may be generic; each instance is a tag and a union of its own.

use bessemer::prelude::*;

/// A received value: new, repeated, or missing.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Received<T> {
    /// Received for the first time.
    New(T),
    /// Received before: the value and its age in periods.
    Again { value: T, age: u32 },
    /// Nothing came.
    #[default]
    Nothing,
}

#[data]
impl<T: Real> Received<T> {
    /// The value, or `other` if nothing was received.
    pub fn value_or(&self, other: T) -> T {
        match self {
            Received::New(value) => *value,
            Received::Again { value, .. } => *value,
            Received::Nothing => other,
        }
    }
}

/// The mean of two received values; `otherwise` replaces a missing one.
#[function]
pub fn middle(low: &Received<f32>, high: &Received<f32>, otherwise: f32) -> f32 {
    (low.value_or(otherwise) + high.value_or(otherwise)) / 2.0
}

/// State of a value after a period without a new one.
#[function]
pub fn aged(last: &Received<f64>) -> Received<f64> {
    match *last {
        Received::New(value) => Received::Again { value, age: 1 },
        Received::Again { value, age } if age < 5 => Received::Again { value, age: age + 1 },
        _ => Received::Nothing,
    }
}
