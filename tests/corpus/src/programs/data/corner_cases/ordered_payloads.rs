//! `<` of two values reads a payload only where both have its variant. An array in it is compared by a loop, before the
//! condition of which it is a part.

use bessemer::prelude::*;

/// Report of a sensor.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub enum SensorReport {
    /// A level.
    Level(i32),
    /// Nothing.
    Missing,
    /// Samples, and true if they are complete.
    Window([i16; 6], bool),
}

/// A report of one of the three kinds.
#[function]
pub fn sensor_report(kind: u8, level: i32) -> SensorReport {
    match kind % 3 {
        0 => SensorReport::Level(level),
        1 => SensorReport::Missing,
        _ => SensorReport::Window([1, 2, 3, 4, level as i16, (level / 7) as i16], level > 0),
    }
}

/// The four orders of two reports, as bits.
#[function]
pub fn orders_of_reports(one: u8, other: u8, x: i32, y: i32) -> u8 {
    let (a, b) = (sensor_report(one, x), sensor_report(other, y));
    let mut bits = 0_u8;
    for holds in [a < b, a <= b, a > b, a >= b] {
        bits = bits << 1 | u8::from(holds);
    }
    bits
}

/// The orders of two optional reports, as bits.
#[function]
pub fn orders_of_optional_reports(one: u8, other: u8, x: i32, y: i32) -> u8 {
    let some = |kind: u8, level| if kind > 9 { Some(sensor_report(kind, level)) } else { None };
    let (a, b) = (some(one, x), some(other, y));
    u8::from(a < b) << 1 | u8::from(a >= b)
}
