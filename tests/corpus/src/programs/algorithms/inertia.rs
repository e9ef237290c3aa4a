//! The inertia of a body made of point masses, computed with the columns of a matrix.

use bessemer::prelude::*;

/// Inertia tensor of point masses about the origin. Each column of `places` is a position in m; masses are in kg.
#[function]
pub fn inertia(places: &SMatrix<f64, 3, 5>, masses: &SVector<f64, 5>) -> Matrix3<f64> {
    let mut inertia = Matrix3::zeros();
    for (k, mass) in masses.iter().enumerate() {
        let r = places.column(k).into_owned();
        inertia += (Matrix3::identity() * r.norm_squared() - r * r.transpose()) * *mass;
    }
    inertia
}

/// Centre of mass, m.
#[function]
pub fn centre(places: &SMatrix<f64, 3, 5>, masses: &SVector<f64, 5>) -> Vector3<f64> {
    places * masses / masses.sum()
}

/// The positions relative to the centre of mass.
#[function]
pub fn centred(places: &SMatrix<f64, 3, 5>, masses: &SVector<f64, 5>) -> SMatrix<f64, 3, 5> {
    let centre = centre(places, masses);
    let mut centred = *places;
    for k in 0..5 {
        let place = centred.column(k) - centre;
        centred.set_column(k, &place);
    }
    centred
}
