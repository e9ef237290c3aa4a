//! The type, not the name, decides which `new` and `from_euler_angles` is called. An author's `Rotation2` has its own
//! methods; nalgebra's has the DSL's under any alias.

use bessemer::prelude::*;

/// A rotation in the plane, counted by an encoder.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation2 {
    /// Steps of 1/4096 of a turn.
    pub steps: i32,
}

#[data]
impl Rotation2 {
    /// A rotation of some steps.
    pub fn new(steps: i32) -> Rotation2 {
        Rotation2 { steps: steps & 0xfff }
    }

    /// Converts whole degrees.
    pub fn from_euler_angles(degrees: i16) -> Rotation2 {
        Rotation2::new(i32::from(degrees) * 512 / 45)
    }

    /// The difference of two rotations.
    pub fn rotation_between(self, other: Rotation2) -> Rotation2 {
        Self::new(other.steps - self.steps)
    }
}

/// Calls the author's methods.
#[function]
pub fn own(degrees: i16, steps: i32) -> Rotation2 {
    let turned = Rotation2::from_euler_angles(degrees);
    turned.rotation_between(Rotation2::new(steps))
}

/// An alias of nalgebra's type.
pub type Attitude = UnitQuaternion<f64>;

/// Calls the DSL's function by the alias.
#[function]
pub fn renamed(roll: f64, pitch: f64, yaw: f64) -> UnitQuaternion<f64> {
    Attitude::from_euler_angles(roll, pitch, yaw)
}

/// Rotation matrices from an axis whose length is the angle.
#[function]
pub fn in_space(a: Vector3<f64>, b: Vector3<f64>) -> Matrix3<f64> {
    let first = Rotation3::new(a);
    let second = Rotation3::from_scaled_axis(b);
    first.matrix() * second.matrix()
}

/// A rotation matrix in the plane.
#[function]
pub fn in_the_plane(angle: f32) -> Matrix2<f32> {
    bessemer::nalgebra::Rotation2::new(angle).into_inner()
}
