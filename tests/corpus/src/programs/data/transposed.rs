//! `transpose` between options of results and results of options.

use bessemer::prelude::*;

/// Reason why a reading is invalid.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Broken {
    /// Above the range of the sensor.
    Above,
    /// Below the range of the sensor: the reading.
    Below(i16),
}

/// Checks the range of a reading.
#[function]
pub fn checked(reading: i16) -> Result<i16, Broken> {
    match reading {
        i16::MIN..0 => Err(Broken::Below(reading)),
        0..1000 => Ok(reading),
        _ => Err(Broken::Above),
    }
}

/// Checks a reading that may be missing.
#[function]
pub fn perhaps(reading: Option<i16>) -> Result<Option<i16>, Broken> {
    let reading = reading.map(|reading| checked(reading)).transpose()?;
    Ok(reading.filter(|reading| *reading > 10))
}

/// A valid reading, or the error; `None` if there is none.
#[function]
pub fn some(reading: Result<Option<i16>, Broken>) -> Option<Result<i16, Broken>> {
    reading.transpose()
}

/// Both parts of an optional pair.
#[function]
pub fn parts(pair: Option<(u8, f32)>) -> (Option<u8>, Option<f32>) {
    pair.unzip()
}
