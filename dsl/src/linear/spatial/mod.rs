//! Rotations and poses: what nalgebra's operations on `Quaternion`, `UnitQuaternion`, `Rotation` and `Isometry3`
//! compute, in the same order of operations.
//!
//! The simulation calls nalgebra; the C is generated from these functions. A quaternion is a struct in the C, whether
//! or not it is a unit quaternion; a `Rotation` is its matrix, and a `Point`, a `Translation` and a `Unit` of a
//! vector are that vector.
//!
//! Not here: functions that need the sine and cosine of an angle; see [`crate::rotation`].

pub mod isometry;
pub mod quaternion;
pub mod unit_quaternion;
