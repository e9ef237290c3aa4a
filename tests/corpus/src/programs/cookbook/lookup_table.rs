//! A lookup table with uneven breakpoints: the temperature of a thermistor from the counts of a 12-bit converter.
//!
//! The block `Axis` searches, and the values between its points are linear. The table is a named constant in flash. A
//! broken or shorted sensor gives no temperature rather than a wrong one.

use bessemer::prelude::*;
pub use bessemer_blocks::{Axis, Beyond, interpolated};

/// Counts of the converter, ascending. The thermistor has 10 kΩ at 25 °C and B = 3950 K, and is between the pin and
/// ground; 10 kΩ are between the pin and the reference.
#[data]
pub static NTC_COUNTS: Axis<f32, 10> = Axis {
    points: [160.2, 267.1, 461.7, 707.1, 1081.6, 1419.1, 1825.1, 2278.4, 2738.6, 3157.0],
};
/// The temperature at each of these counts, °C.
#[data]
#[unit("°C")]
pub static NTC_TEMPERATURES: [f32; 10] =
    [120.0, 100.0, 80.0, 65.0, 50.0, 40.0, 30.0, 20.0, 10.0, 0.0];

/// Fewer counts than this are a short to ground.
pub const SHORTED: u16 = 100;
/// More counts than this are a broken wire.
pub const BROKEN: u16 = 4000;

/// The temperature, 0 to 120 °C; `None` if the sensor is broken or shorted.
#[function]
#[unit("°C")]
pub fn thermistor(counts: u16) -> Option<f32> {
    if counts < SHORTED || counts > BROKEN {
        return None;
    }
    Some(interpolated(&NTC_TEMPERATURES, NTC_COUNTS.place(f32::from(counts), Beyond::Hold)))
}
