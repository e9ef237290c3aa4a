//! The type, not the name, decides which `new` and `from_euler_angles` is called: an
//! own `Rotation2` has its own methods, and nalgebra's has the DSL's under any alias.

use bessemer::prelude::*;

/// A turn in the plane, in steps of an encoder.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation2 {
    /// Steps of 1/4096 of a turn.
    pub steps: i32,
}

#[data]
impl Rotation2 {
    /// So many steps.
    pub fn new(steps: i32) -> Rotation2 {
        Rotation2 { steps: steps & 0xfff }
    }

    /// From whole degrees.
    pub fn from_euler_angles(degrees: i16) -> Rotation2 {
        Rotation2::new(i32::from(degrees) * 512 / 45)
    }

    /// Back by as much.
    pub fn rotation_between(self, other: Rotation2) -> Rotation2 {
        Self::new(other.steps - self.steps)
    }
}

/// The author's own.
#[function]
pub fn own(degrees: i16, steps: i32) -> Rotation2 {
    let turned = Rotation2::from_euler_angles(degrees);
    turned.rotation_between(Rotation2::new(steps))
}

/// nalgebra's.
pub type Attitude = UnitQuaternion<f64>;

/// nalgebra's by another name.
#[function]
pub fn renamed(roll: f64, pitch: f64, yaw: f64) -> UnitQuaternion<f64> {
    Attitude::from_euler_angles(roll, pitch, yaw)
}

/// Matrices from an axis as long as the angle.
#[function]
pub fn in_space(a: Vector3<f64>, b: Vector3<f64>) -> Matrix3<f64> {
    let first = Rotation3::new(a);
    let second = Rotation3::from_scaled_axis(b);
    first.matrix() * second.matrix()
}

/// In the plane.
#[function]
pub fn in_the_plane(angle: f32) -> Matrix2<f32> {
    bessemer::nalgebra::Rotation2::new(angle).into_inner()
}
