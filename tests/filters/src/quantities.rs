//! Numbers with a meaning.

use bessemer::prelude::*;

/// A length.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Metres(pub f64);

#[data]
impl core::ops::Add for Metres {
    type Output = Metres;

    fn add(self, other: Metres) -> Metres {
        Metres(self.0 + other.0)
    }
}

#[data]
impl Metres {
    /// Its number.
    pub fn number(&self) -> f64 {
        self.0
    }
}
