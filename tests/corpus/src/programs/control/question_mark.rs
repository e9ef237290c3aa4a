//! `?` takes the value, or returns what there is in its place.

use bessemer::prelude::*;

/// Why there is no voltage.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Failure {
    #[default]
    Open,
    Short,
}

/// The voltage of a converter's count.
#[function]
pub fn voltage(count: u16) -> Result<f64, Failure> {
    match count {
        0..=9 => Err(Failure::Short),
        4000.. => Err(Failure::Open),
        _ => Ok(count as f64 / 1000.0),
    }
}

/// The power of a voltage and a current, both as counts.
#[function]
pub fn power(volts: u16, amperes: u16) -> Result<f64, Failure> {
    let u = voltage(volts)?;
    let i = voltage(amperes)?;
    Ok(u * i)
}
