//! `<` of values whose parts are arrays, tuples, structs and enums with payload. A payload is read only where both values
//! have its variant.

use core::cmp::Reverse;

use bessemer::prelude::*;

/// A span of levels.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct LevelSpan {
    /// The lowest level.
    pub low: f32,
    /// The highest level.
    pub high: f32,
}

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
    /// A span of levels.
    Span(LevelSpan),
    /// Two rows of samples.
    Rows([[u8; 2]; 9]),
}

/// A report of one of the five kinds.
#[function]
pub fn sensor_report(kind: u8, level: i32) -> SensorReport {
    match kind % 5 {
        0 => SensorReport::Level(level),
        1 => SensorReport::Missing,
        2 => SensorReport::Window([1, 2, 3, 4, level as i16, (level / 7) as i16], level > 0),
        3 => SensorReport::Span(LevelSpan { low: (level % 3) as f32 / 0.0, high: level as f32 }),
        _ => {
            let mut rows = [[3; 2]; 9];
            rows[8] = [(level % 2) as u8, (level % 5) as u8];
            SensorReport::Rows(rows)
        }
    }
}

/// The four orders of two reports, as bits.
#[function]
pub fn orders_of_reports(kinds: u8, x: i32, y: i32) -> u8 {
    let (a, b) = (sensor_report(kinds % 5, x), sensor_report(kinds / 5, y));
    let mut bits = 0_u8;
    for holds in [a < b, a <= b, a > b, a >= b] {
        bits = bits << 1 | u8::from(holds);
    }
    bits
}

/// The orders of two optional reports, as bits.
#[function]
pub fn orders_of_optional_reports(kinds: u8, x: i32, y: i32) -> u8 {
    let some = |kind: u8, level| if kind < 5 { Some(sensor_report(kind, level)) } else { None };
    let (a, b) = (some(kinds % 6, x), some(kinds / 6 % 6, y));
    u8::from(a < b) << 1 | u8::from(a >= b)
}

/// The orders of two results, as bits: an `Ok` comes before an `Err`.
#[function]
pub fn orders_of_results(kinds: u8, x: i32, y: i32) -> u8 {
    let result = |kind: u8, level: i32| match kind < 5 {
        true => Ok(sensor_report(kind, level)),
        false => Err([level, -level, 3]),
    };
    let (a, b) = (result(kinds % 6, x), result(kinds / 6 % 6, y));
    u8::from(a <= b) << 1 | u8::from(a > b)
}

/// The orders of tuples with reports, from both ends, as bits.
#[function]
pub fn orders_of_tuples(kinds: u8, x: i32, y: i32) -> u8 {
    let (a, b) = (sensor_report(kinds % 5, x), sensor_report(kinds / 5, y));
    let by_level = (x, a) < (y, b);
    let by_report = (a, [x; 2]) >= (b, [y; 2]);
    let reversed = (Reverse(a), x) <= (Reverse(b), y);
    u8::from(by_level) << 2 | u8::from(by_report) << 1 | u8::from(reversed)
}

/// The orders of long arrays, as bits.
#[function]
pub fn orders_of_arrays(x: [u8; 12], at: usize, y: u8) -> u8 {
    let mut other = x;
    other[at % 12] = y;
    let mut pairs = [(0, 0.0); 5];
    pairs[at % 5] = (y, f64::from(y));
    u8::from(x < other) << 2 | u8::from(x >= other) << 1 | u8::from(pairs <= [(x[0], 7.0); 5])
}

/// True if the first report comes before the second, and no level is behind the limit.
#[function]
pub fn comes_in_time(kinds: u8, levels: [i32; 3], limit: i32) -> bool {
    levels.iter().all(|level| *level <= limit)
        && sensor_report(kinds % 5, levels[0]) < sensor_report(kinds / 5, levels[1])
}
