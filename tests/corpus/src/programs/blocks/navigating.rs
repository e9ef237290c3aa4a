//! Positions on the earth in local coordinates.

use bessemer::prelude::*;
pub use bessemer_blocks::{
    Geodetic, ecef_from_enu, ecef_from_geodetic, enu_from_ecef, geodetic_from_ecef, ned_from_enu,
};

/// North, east and down of a position seen from an origin, m.
#[function]
pub fn seen(origin: &Geodetic<f64>, position: &Geodetic<f64>) -> Vector3<f64> {
    ned_from_enu(&enu_from_ecef(origin, &ecef_from_geodetic(position)))
}

/// The position at north, east and down from an origin, m.
#[function]
pub fn reached(origin: &Geodetic<f64>, offset: &Vector3<f64>) -> Geodetic<f64> {
    geodetic_from_ecef(&ecef_from_enu(origin, &ned_from_enu(offset)))
}

/// Up in earth-fixed coordinates, in single precision.
#[function]
pub fn vertical(origin: &Geodetic<f32>) -> Vector3<f32> {
    bessemer_blocks::enu_rotation(origin).transpose() * Vector3::new(0.0, 0.0, 1.0)
}
