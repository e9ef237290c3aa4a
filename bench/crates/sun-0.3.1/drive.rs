//! Calls of `sun` over plain numbers.

use crate::*;

pub fn position(time: i64, lat: f64, lon: f64) -> (f64, f64) {
    let found = pos(time, lat, lon);
    (found.azimuth, found.altitude)
}

pub fn rise(time: i64, lat: f64, lon: f64, height: f64) -> i64 {
    time_at_phase(time, SunPhase::Sunrise, lat, lon, height)
}

pub fn at_angle(time: i64, angle: f64, rising: bool, lat: f64, lon: f64) -> i64 {
    time_at_phase(time, SunPhase::custom(angle, rising), lat, lon, 0.0)
}
