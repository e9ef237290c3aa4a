//! Calls of `map_3d` over plain numbers.

use crate::*;

pub fn from_geodetic(at: [f64; 3], of: [f64; 3]) -> [(f64, f64, f64); 3] {
    let e = Ellipsoid::default();
    [
        geodetic2ecef(at[0], at[1], at[2], e),
        geodetic2aer(at[0], at[1], at[2], of[0], of[1], of[2], e),
        geodetic2ned(at[0], at[1], at[2], of[0], of[1], of[2], e),
    ]
}

pub fn from_aer(at: [f64; 3], of: [f64; 3], gst: f64) -> [(f64, f64, f64); 4] {
    let e = Ellipsoid::WGS72;
    [
        aer2ecef(at[0], at[1], at[2], of[0], of[1], of[2], e),
        aer2eci(gst, at[0], at[1], at[2], of[0], of[1], of[2], e),
        aer2ned(at[0], at[1], at[2]),
        aer2geodetic(at[0], at[1], at[2], of[0], of[1], of[2], e),
    ]
}

pub fn from_ecef(at: [f64; 3], of: [f64; 3], gst: f64) -> [(f64, f64, f64); 4] {
    let e = Ellipsoid::WGS84;
    [
        ecef2geodetic(at[0], at[1], at[2], e),
        ecef2enu(at[0], at[1], at[2], of[0], of[1], of[2], e),
        ecef2aer(at[0], at[1], at[2], of[0], of[1], of[2], e),
        ecef2eci(gst, at[0], at[1], at[2]),
    ]
}

pub fn from_ned(at: [f64; 3], of: [f64; 3], gst: f64) -> [(f64, f64, f64); 4] {
    let e = Ellipsoid::Airy;
    [
        ned2aer(at[0], at[1], at[2]),
        ned2geodetic(at[0], at[1], at[2], of[0], of[1], of[2], e),
        ned2ecef(at[0], at[1], at[2], of[0], of[1], of[2], e),
        eci2aer(gst, at[0], at[1], at[2], of[0], of[1], of[2], e),
    ]
}

pub fn sidereal(utc: [i32; 6]) -> f64 {
    utc2gst(utc)
}

pub fn far(one: (f64, f64), other: (f64, f64)) -> f64 {
    distance(one, other)
}

pub fn products(m: [f64; 9], v: [f64; 3]) -> ([f64; 3], [f64; 9]) {
    (matmul3(m, v), transpose3(m))
}
