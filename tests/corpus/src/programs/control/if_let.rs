//! `if let` tests and destructures a value; further conditions may follow. `matches!` only tests.

use bessemer::prelude::*;

/// Last reading of the altimeter.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Altimeter {
    /// Height, m.
    pub height: Option<f64>,
    pub errors: u8,
}

/// The height to use, m.
#[function]
pub fn height(altimeter: &Altimeter, other: f64) -> f64 {
    if let Some(height) = altimeter.height && altimeter.errors < 3 { height } else { other }
}

/// Adds to a height, if there is one.
#[function]
pub fn lift(altimeter: &mut Altimeter, by: f64) {
    if let Some(height) = &mut altimeter.height {
        *height += by;
    }
}

/// Returns true if it is near the ground.
#[function]
pub fn is_low(altimeter: &Altimeter) -> bool {
    matches!(altimeter.height, Some(height) if height < 0.5)
}
