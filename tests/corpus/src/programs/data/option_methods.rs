//! Methods of `Option` with closures become branches.

use bessemer::prelude::*;

/// The temperature in °C for a reading of 12 bits; `None` if the sensor is not connected.
#[function]
pub fn celsius(reading: Option<u16>) -> Option<f64> {
    reading.filter(|raw| *raw < 4095).map(|raw| f64::from(raw) * 0.05 - 40.0)
}

/// The reciprocal; `None` for 0.
#[function]
pub fn inverted(x: Option<f32>) -> Option<f32> {
    x.and_then(|x| if x == 0.0 { None } else { Some(1.0 / x) })
}

/// Returns true if there is a temperature and it is too high.
#[function]
pub fn alarm(temperature: Option<f64>, limit: f64) -> bool {
    temperature.is_some_and(|t| t > limit)
}

/// The first value that is present, else the middle of the range.
#[function]
pub fn chosen(one: Option<f32>, other: Option<f32>, low: f32, high: f32) -> f32 {
    one.or_else(|| other).unwrap_or_else(|| (low + high) / 2.0)
}

/// The duty cycle of a command in percent; 0 if there is none.
#[function]
pub fn duty(command: Option<u8>) -> f32 {
    command.map_or(0.0, |percent| f32::from(percent.min(100)) / 100.0)
}

/// Both readings; `None` if one is missing.
#[function]
pub fn both(position: Option<f64>, speed: Option<f64>) -> Option<(f64, f64)> {
    position.zip(speed)
}
