//! WGS84: geodetic, earth-fixed and local coordinates; sines by the path of nalgebra's trait, as Rust without std calls them.

use bessemer::prelude::*;
#[allow(unused_imports)]
use bessemer::nalgebra::{ComplexField, Matrix3, RealField, Rotation3, Vector3};

#[data]
pub struct Ellipsoid {
    pub a: f64,
    pub f: f64,
}

pub const WGS84: Ellipsoid = Ellipsoid { a: 6_378_137.0, f: 1.0 / 298.257_223_563 };

#[data]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geodetic {
    pub latitude: f64,
    pub longitude: f64,
    pub height: f64,
}

#[data]
impl Ellipsoid {
    const fn e2(&self) -> f64 {
        self.f * (2.0 - self.f)
    }

    fn prime_vertical(&self, sin_lat: f64) -> f64 {
        self.a / ComplexField::sqrt(1.0 - self.e2() * sin_lat * sin_lat)
    }

    pub fn to_ecef(&self, g: &Geodetic) -> Vector3<f64> {
        let (slat, clat) = ComplexField::sin_cos(g.latitude);
        let (slon, clon) = ComplexField::sin_cos(g.longitude);
        let n = self.prime_vertical(slat);
        Vector3::new(
            (n + g.height) * clat * clon,
            (n + g.height) * clat * slon,
            (n * (1.0 - self.e2()) + g.height) * slat,
        )
    }

    pub fn to_geodetic(&self, p: &Vector3<f64>) -> Geodetic {
        let rho = p.xy().norm();
        let longitude = RealField::atan2(p.y, p.x);
        let mut latitude = RealField::atan2(p.z, rho * (1.0 - self.e2()));
        let mut height = 0.0;
        for _ in 0..6 {
            let (s, c) = ComplexField::sin_cos(latitude);
            let n = self.prime_vertical(s);
            height = rho / c - n;
            latitude = RealField::atan2(p.z, rho * (1.0 - self.e2() * n / (n + height)));
        }
        Geodetic { latitude, longitude, height }
    }
}

/// Rotation from ECEF to the local east-north-up frame.
#[function]
pub fn enu_rotation(g: &Geodetic) -> Rotation3<f64> {
    let (slat, clat) = ComplexField::sin_cos(g.latitude);
    let (slon, clon) = ComplexField::sin_cos(g.longitude);
    Rotation3::from_matrix_unchecked(Matrix3::new(
        -slon,
        clon,
        0.0,
        -slat * clon,
        -slat * slon,
        clat,
        clat * clon,
        clat * slon,
        slat,
    ))
}

#[function]
pub fn to_enu(origin: &Geodetic, target: &Geodetic) -> Vector3<f64> {
    let delta = WGS84.to_ecef(target) - WGS84.to_ecef(origin);
    enu_rotation(origin) * delta
}

#[function]
pub fn offset(origin_deg: [f64; 3], target_deg: [f64; 3]) -> [f64; 3] {
    let parse = |[lat, lon, height]: [f64; 3]| Geodetic {
        latitude: lat.to_radians(),
        longitude: lon.to_radians(),
        height,
    };
    to_enu(&parse(origin_deg), &parse(target_deg)).into()
}

#[function]
pub fn there_and_back(lat: f64, lon: f64, height: f64) -> [f64; 3] {
    let g = Geodetic { latitude: lat, longitude: lon, height };
    let back = WGS84.to_geodetic(&WGS84.to_ecef(&g));
    [back.latitude - lat, back.longitude - lon, back.height - height]
}
