//! Options of results and results of options, turned inside out.

use bessemer::prelude::*;

/// Why a reading is none.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Broken {
    /// Above what the sensor shows.
    Above,
    /// Below.
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

/// A reading, if there is one, in range.
#[function]
pub fn perhaps(reading: Option<i16>) -> Result<Option<i16>, Broken> {
    let reading = reading.map(|reading| checked(reading)).transpose()?;
    Ok(reading.filter(|reading| *reading > 10))
}

/// A reading in range, or the reason why there is none.
#[function]
pub fn some(reading: Result<Option<i16>, Broken>) -> Option<Result<i16, Broken>> {
    reading.transpose()
}

/// The parts of a pair that may be missing.
#[function]
pub fn parts(pair: Option<(u8, f32)>) -> (Option<u8>, Option<f32>) {
    pair.unzip()
}
