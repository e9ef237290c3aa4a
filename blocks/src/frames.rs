//! Coordinate frames of the earth: geodetic, earth-fixed (ECEF), and local east-north-up (ENU) and north-east-down (NED).
//!
//! Lengths are m, angles rad. The ellipsoid is WGS 84's. In `f32` earth-fixed coordinates have steps of 0.5 m, so
//! use `f64` for them, and either for local ones.
//!
//! Source: Bowring, *The Accuracy of Geodetic Latitude and Height Equations*, Survey Review 28 (218), 1985; National
//! Geospatial-Intelligence Agency, *World Geodetic System 1984*, NGA.STND.0036, 2014.

use bessemer::prelude::*;

/// Semi-major axis of the ellipsoid, m.
pub const SEMI_MAJOR_AXIS: f64 = 6_378_137.0;
/// Flattening of the ellipsoid.
pub const FLATTENING: f64 = 1.0 / 298.257_223_563;
/// Square of the first eccentricity.
const ECCENTRICITY_SQUARED: f64 = FLATTENING * (2.0 - FLATTENING);
/// Steps of Bowring's iteration: one more than double precision needs near the surface.
const STEPS: u32 = 3;

/// Geodetic position.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Geodetic<T> {
    /// Latitude, −π/2 to π/2.
    #[unit("rad")]
    pub latitude: T,
    /// Longitude, −π to π.
    #[unit("rad")]
    pub longitude: T,
    /// Height above the ellipsoid.
    #[unit("m")]
    pub height: T,
}

/// Earth-fixed coordinates of a geodetic position, m.
///
/// ```
/// use bessemer_blocks::{Geodetic, ecef_from_geodetic, geodetic_from_ecef};
///
/// let zurich = Geodetic { latitude: 0.8268_f64, longitude: 0.1491, height: 408.0 };
/// let back = geodetic_from_ecef(&ecef_from_geodetic(&zurich));
/// assert!((back.latitude - zurich.latitude).abs() < 1e-14 && (back.height - zurich.height).abs() < 1e-8);
/// ```
#[function]
pub fn ecef_from_geodetic<T: Real>(position: &Geodetic<T>) -> Vector3<T> {
    let (sine, cosine) = position.latitude.sin_cos();
    let (sine_longitude, cosine_longitude) = position.longitude.sin_cos();
    let eccentricity = real::<T>(ECCENTRICITY_SQUARED);
    let normal = real::<T>(SEMI_MAJOR_AXIS) / (T::ONE - eccentricity * sine * sine).sqrt();
    let across = (normal + position.height) * cosine;
    Vector3::new(
        across * cosine_longitude,
        across * sine_longitude,
        (normal * (T::ONE - eccentricity) + position.height) * sine,
    )
}

/// Geodetic position of earth-fixed coordinates, m.
///
/// Range: exact to rounding from 5000 km below the surface to orbits; the earth's centre gives NaN. On the earth's axis, the
/// longitude is 0.
#[function]
pub fn geodetic_from_ecef<T: Real>(position: &Vector3<T>) -> Geodetic<T> {
    let semi_major = real::<T>(SEMI_MAJOR_AXIS);
    let eccentricity = real::<T>(ECCENTRICITY_SQUARED);
    // The semi-minor axis by the semi-major one, and the square of the second eccentricity.
    let ratio = real::<T>(1.0 - FLATTENING);
    let second = real::<T>(ECCENTRICITY_SQUARED / (1.0 - ECCENTRICITY_SQUARED));
    let across = position.x.hypot(position.y);
    // Direction of the parametric latitude.
    let (mut along, mut up) = (across * ratio, position.z);
    let (mut cosine, mut sine) = (T::ONE, T::ZERO);
    for _ in 0..STEPS {
        let length = along.hypot(up);
        let (c, s) = (along / length, up / length);
        cosine = across - eccentricity * semi_major * c * c * c;
        sine = position.z + second * semi_major * ratio * s * s * s;
        along = cosine;
        up = ratio * sine;
    }
    let latitude = sine.atan2(cosine);
    let length = cosine.hypot(sine);
    let (c, s) = (cosine / length, sine / length);
    let surface = semi_major * (T::ONE - eccentricity * s * s).sqrt();
    Geodetic {
        latitude,
        longitude: position.y.atan2(position.x),
        height: across * c + position.z * s - surface,
    }
}

/// Rotation from earth-fixed to east-north-up coordinates at a position.
#[function]
pub fn enu_rotation<T: Real>(origin: &Geodetic<T>) -> Matrix3<T> {
    let (s, c) = origin.latitude.sin_cos();
    let (sl, cl) = origin.longitude.sin_cos();
    Matrix3::new(-sl, cl, T::ZERO, -s * cl, -s * sl, c, c * cl, c * sl, s)
}

/// East-north-up coordinates, at an origin, of a point in earth-fixed coordinates, m.
///
/// ```
/// use bessemer_blocks::{Geodetic, ecef_from_enu, ecef_from_geodetic, enu_from_ecef};
/// use bessemer::nalgebra::Vector3;
///
/// let origin = Geodetic { latitude: 0.8, longitude: 0.1, height: 0.0 };
/// let above = ecef_from_geodetic(&Geodetic { height: 100.0, ..origin });
/// assert!((enu_from_ecef(&origin, &above) - Vector3::new(0.0, 0.0, 100.0)).norm() < 1e-8);
/// assert!((ecef_from_enu(&origin, &Vector3::new(0.0, 0.0, 100.0)) - above).norm() < 1e-8);
/// ```
#[function]
pub fn enu_from_ecef<T: Real>(origin: &Geodetic<T>, point: &Vector3<T>) -> Vector3<T> {
    enu_rotation(origin) * (point - ecef_from_geodetic(origin))
}

/// Earth-fixed coordinates of a point in east-north-up coordinates at an origin, m.
#[function]
pub fn ecef_from_enu<T: Real>(origin: &Geodetic<T>, point: &Vector3<T>) -> Vector3<T> {
    enu_rotation(origin).transpose() * point + ecef_from_geodetic(origin)
}

/// North-east-down coordinates of east-north-up ones, and the inverse: x and y are exchanged, z changes its sign.
///
/// ```
/// use bessemer::nalgebra::Vector3;
///
/// assert_eq!(bessemer_blocks::ned_from_enu(&Vector3::new(1.0, 2.0, 3.0)), Vector3::new(2.0, 1.0, -3.0));
/// ```
#[function]
pub fn ned_from_enu<T: Real>(vector: &Vector3<T>) -> Vector3<T> {
    Vector3::new(vector.y, vector.x, -vector.z)
}
