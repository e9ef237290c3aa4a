//! A type with a `Deref` that nothing marked uses: the simulation may.

use bessemer::prelude::*;

/// A voltage.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Volts(pub f64);

impl core::ops::Deref for Volts {
    type Target = f64;

    fn deref(&self) -> &f64 {
        &self.0
    }
}

#[data]
impl Volts {
    /// Half of it.
    pub fn half(self) -> Volts {
        Volts(0.5 * self.0)
    }
}

/// Names the field.
#[function]
pub fn doubled(volts: f64) -> f64 {
    4.0 * Volts(volts).half().0
}
