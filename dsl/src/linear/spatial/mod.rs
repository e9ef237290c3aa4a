//! Rotations and poses: what nalgebra's operations on `Quaternion`, `UnitQuaternion`, `Rotation` and
//! `Isometry3` compute, in its order.
//!
//! The simulation calls nalgebra; the C is made from here. A quaternion is a struct in the C, unit or not;
//! a `Rotation` is its matrix, and a `Point`, a `Translation` and a `Unit` of a vector is that vector.
//!
//! Absent: what takes sine and cosine of an angle ([`crate::rotation`]).

pub mod isometry;
pub mod quaternion;
pub mod unit_quaternion;
