//! The unit of a field stands in its comment.

use bessemer::prelude::*;

/// What the barometer says.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Barometer {
    /// Pressure of the air.
    #[unit("Pa")]
    pub pressure: f32,
    #[unit("°C")]
    pub temperature: f32,
}

/// The density of dry air, kg/m³.
#[function]
pub fn density(reading: &Barometer) -> f32 {
    reading.pressure / (287.05 * (reading.temperature + 273.15))
}
