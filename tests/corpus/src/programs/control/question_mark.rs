//! `?` evaluates to the value, or returns the error.

use bessemer::prelude::*;

/// Reason why there is no voltage.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Failure {
    #[default]
    Open,
    Short,
}

/// The voltage for a count of an analog-to-digital converter.
#[function]
pub fn voltage(count: u16) -> Result<f64, Failure> {
    match count {
        0..=9 => Err(Failure::Short),
        4000.. => Err(Failure::Open),
        _ => Ok(count as f64 / 1000.0),
    }
}

/// The power from a voltage and a current, both as counts of a converter.
#[function]
pub fn power(volts: u16, amperes: u16) -> Result<f64, Failure> {
    let u = voltage(volts)?;
    let i = voltage(amperes)?;
    Ok(u * i)
}
