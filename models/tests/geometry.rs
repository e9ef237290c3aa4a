//! Orientation against what it means: an orthonormal rotation, and its numerical derivative.

use bessemer::nalgebra::{Matrix3, Vector3};
use models::Orientation;

/// Angles over the whole range of flight, pitch short of its singularity.
fn samples() -> Vec<Vector3<f64>> {
    let mut all = Vec::new();
    for roll in [-2.5, -0.7, 0.0, 0.3, 1.9] {
        for pitch in [-1.2, -0.4, 0.0, 0.6, 1.3] {
            for yaw in [-3.0, -1.1, 0.0, 0.3, 2.2] {
                all.push(Vector3::new(roll, pitch, yaw));
            }
        }
    }
    all
}

fn rotation(angles: &Vector3<f64>) -> Matrix3<f64> {
    Orientation::of(angles).rotation()
}

#[test]
fn rotation_is_orthonormal_and_proper() {
    for angles in samples() {
        let r = rotation(&angles);
        assert!((r * r.transpose() - Matrix3::identity()).norm() < 1e-14, "{angles}");
        assert!((r.determinant() - 1.0).abs() < 1e-14, "{angles}");
    }
}

#[test]
fn rotation_is_its_three_turns() {
    for angles in samples() {
        let turn = |x, y, z| rotation(&Vector3::new(x, y, z));
        let product =
            turn(angles.x, 0.0, 0.0) * turn(0.0, angles.y, 0.0) * turn(0.0, 0.0, angles.z);
        assert!((rotation(&angles) - product).norm() < 1e-14, "{angles}");
    }
}

#[test]
fn positive_angles_are_passive() {
    // C3 turns the axes, not the vector: the body's x appears at −yaw in the inertial frame.
    let forward = rotation(&Vector3::new(0.0, 0.0, 0.3)) * Vector3::x();
    assert!((forward - Vector3::new(0.3f64.cos(), -0.3f64.sin(), 0.0)).norm() < 1e-15);
}

#[test]
fn rates_match_the_numerical_derivative_of_the_rotation() {
    // ω× = Rᵀ Ṙ (thesis, eqs. (2.13)–(2.17)).
    let step = 1e-6;
    let angle_rates = Vector3::new(0.7, -0.4, 1.1);
    for angles in samples() {
        let ahead = rotation(&(angles + angle_rates * step));
        let behind = rotation(&(angles - angle_rates * step));
        let spin = rotation(&angles).transpose() * (ahead - behind) / (2.0 * step);
        let body_rates = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);

        let orientation = Orientation::of(&angles);
        assert!((orientation.rate_matrix() * angle_rates - body_rates).norm() < 1e-9, "{angles}");
        assert!((orientation.angle_rates(&body_rates) - angle_rates).norm() < 1e-8, "{angles}");
    }
}

#[test]
fn angle_rates_invert_the_rate_matrix() {
    let body_rates = Vector3::new(0.7, -0.4, 1.1);
    for angles in samples() {
        let orientation = Orientation::of(&angles);
        let there = orientation.angle_rates(&body_rates);
        let back = orientation.rate_matrix() * there;
        assert!((back - body_rates).norm() < 1e-14, "{angles}");
    }
}
