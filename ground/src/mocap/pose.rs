//! Poses of a motion-capture system as readings of the room, and back.
//!
//! A quaternion rotates the body's axes forward, left and up into those of the system. The thesis' angles are of
//! `sim::plant::rotation`.

use super::Up;
use models::calibration::Vicon;
use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};
use sim::plant::rotation;

/// Least norm of a quaternion that is a rotation: those on the wire are of norm 1, with the error of single precision.
const LEAST_NORM: f32 = 0.5;

/// Returns the reading for a position, m, and a quaternion as x, y, z, w; none if they are no pose.
///
/// A number may not be finite, and a quaternion no rotation.
pub fn reading(up: Up, position: [f32; 3], orientation: [f32; 4]) -> Option<Vicon> {
    let norm = orientation.iter().map(|it| it * it).sum::<f32>().sqrt();
    let finite = position.iter().all(|it| it.is_finite()) && norm.is_finite();
    if !finite || norm < LEAST_NORM {
        return None;
    }
    let [x, y, z, w] = orientation.map(f64::from);
    let axis = from_system(up, Vector3::new(x, y, z));
    let quaternion = Quaternion::new(w, axis.x, axis.y, axis.z);
    let turned = UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix();
    let position = from_system(up, Vector3::from(position.map(f64::from)));
    Some(Vicon { fresh: true, position, angles: angles(turned.matrix()) })
}

/// Returns the pose of a reading in a system whose y axis points upwards.
pub fn pose(reading: &Vicon) -> ([f32; 3], [f32; 4]) {
    let turned = Rotation3::from_matrix_unchecked(rotation(&reading.angles));
    let quaternion = UnitQuaternion::from_rotation_matrix(&turned);
    let [x, y, z] = to_system(quaternion.imag());
    (to_system(reading.position).map(|it| it as f32), [x, y, z, quaternion.w].map(|it| it as f32))
}

/// Converts a vector of the system to the room.
fn from_system(up: Up, it: Vector3<f64>) -> Vector3<f64> {
    match up {
        Up::Y => Vector3::new(it.x, -it.z, it.y),
        Up::Z => it,
    }
}

/// Converts a vector of the room to a system whose y axis points upwards.
fn to_system(it: Vector3<f64>) -> [f64; 3] {
    [it.x, it.z, -it.y]
}

/// Returns the thesis' roll, pitch and yaw of a rotation from the body to the room (eq. (2.11)), rad.
fn angles(turned: &Matrix3<f64>) -> Vector3<f64> {
    let roll = turned[(1, 2)].atan2(turned[(2, 2)]);
    let pitch = (-turned[(0, 2)]).clamp(-1.0, 1.0).asin();
    let yaw = turned[(0, 1)].atan2(turned[(0, 0)]);
    Vector3::new(roll, pitch, yaw)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pose_becomes_the_reading_that_it_was() {
        let angles = [-3.0, -1.2, -0.4, 0.0, 0.7, 1.4, 2.9];
        for roll in angles {
            for yaw in angles {
                for pitch in [-1.3, -0.2, 0.0, 0.5, 1.2] {
                    let angles = Vector3::new(roll, pitch, yaw);
                    let position = Vector3::new(1.5, -0.25, 0.875);
                    let known = Vicon { fresh: true, position, angles };
                    let (place, quaternion) = pose(&known);
                    let read = reading(Up::Y, place, quaternion).expect("it is one");
                    assert_eq!(read.position, position);
                    assert!(
                        (read.angles - angles).norm() < 2e-6,
                        "{} is not {angles}",
                        read.angles
                    );
                }
            }
        }
    }

    #[test]
    fn a_system_rotates_like_the_room() {
        // A quarter turn about the axis that points upwards: the nose, which pointed along x, points along the room's y.
        let half = std::f32::consts::FRAC_1_SQRT_2;
        for (up, place, quaternion) in [
            (Up::Y, [1.0, 3.0, -2.0], [0.0, half, 0.0, half]),
            (Up::Z, [1.0, 2.0, 3.0], [0.0, 0.0, half, half]),
        ] {
            let read = reading(up, place, quaternion).expect("it is one");
            assert_eq!(read.position, Vector3::new(1.0, 2.0, 3.0), "{up:?}");
            let nose = rotation(&read.angles) * Vector3::x();
            assert!((nose - Vector3::y()).norm() < 1e-7, "{up:?}: {nose}");
            // The thesis counts yaw clockwise, seen from above.
            assert!((read.angles.z + std::f64::consts::FRAC_PI_2).abs() < 1e-7, "{up:?}");
        }
    }

    #[test]
    fn numbers_that_are_no_pose_are_no_reading() {
        let (place, turn) = ([0.0; 3], [0.0, 0.0, 0.0, 1.0]);
        assert!(reading(Up::Z, place, turn).is_some());
        for wrong in [f32::NAN, f32::INFINITY] {
            assert_eq!(reading(Up::Z, [0.0, wrong, 0.0], turn), None);
            assert_eq!(reading(Up::Z, place, [wrong, 0.0, 0.0, 1.0]), None);
        }
        assert_eq!(reading(Up::Z, place, [0.0; 4]), None);
    }
}
