//! Methods of nalgebra's number traits: limits of the type, conversions from double precision, roots that may not
//! exist.

use bessemer::nalgebra::{self, ComplexField, RealField};
use bessemer::prelude::*;

/// The scaled root of a number, if it exists.
#[function]
fn scaled_root<T: RealField + Copy>(x: T) -> Option<T> {
    let root = (x - T::one()).try_sqrt()?;
    let (low, high) = (T::min_value()?, T::max_value().unwrap_or_else(T::one));
    Some((root * nalgebra::convert::<f64, T>(0.3)).min(high).max(low))
}

/// Uses it in both precisions.
#[function]
pub fn both(x: f64, y: f32) -> (Option<f64>, Option<f32>) {
    (scaled_root(x), scaled_root(y))
}

/// A distance with constants of the type.
#[function]
pub fn distance(x: f32, y: f32) -> f32 {
    (x * x - y * y).try_sqrt().map_or(-1.0, |root| root + x)
}
