//! Units and ranges are in the C's comments. A field, a parameter, a constant or a result may have a unit, which is also
//! in the report of `gen`; a field or a parameter may have a range.

use bessemer::prelude::*;

/// State of the barometer.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Barometer {
    /// Pressure of the air.
    #[unit("Pa")]
    #[range(30e3..=110e3)]
    pub pressure: f32,
    #[unit("°C")]
    pub temperature: f32,
}

/// Specific gas constant of dry air.
#[data]
#[unit("J/(kg·K)")]
const GAS: f32 = 287.05;

/// The density of dry air.
#[function]
#[unit("kg/m³")]
pub fn density(reading: &Barometer) -> f32 {
    reading.pressure / (GAS * (reading.temperature + 273.15))
}

/// Smooths the density of the air.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AirDensity {
    /// Present density.
    #[unit("kg/m³")]
    pub density: f32,
}

#[component]
impl AirDensity {
    /// Takes a reading; returns the smoothed density.
    #[entry(infallible)]
    #[unit("kg/m³")]
    pub fn step(&mut self, reading: &Barometer, #[unit("1/s")] #[range(0..=50)] rate: f32, #[unit("s")] period: f32) -> f32 {
        self.density += (density(reading) - self.density) * rate * period;
        self.density
    }
}
