//! Poses: a rotation and a translation.

use bessemer::prelude::*;

/// The arm of a robot; each joint is mounted on the one before.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// Pose of each joint relative to the one before.
    pub joints: [Isometry3<f64>; 3],
    /// Pose of the tool relative to the base.
    pub tool: Isometry3<f64>,
}

impl Default for Arm {
    fn default() -> Self {
        Arm { joints: [Isometry3::identity(); 3], tool: Isometry3::translation(0.5, 0.0, 1.0) }
    }
}

#[component]
impl Arm {
    /// Turns a joint; returns the new position of the tool.
    #[entry(infallible)]
    pub fn turn(&mut self, at: u8, by: &UnitQuaternion<f64>) -> Point3<f64> {
        let at = (at % 3) as usize;
        self.joints[at] = self.joints[at] * by;
        self.tool = self.joints[0] * self.joints[1] * self.joints[2];
        self.tool * Point3::new(0.0, 0.0, 0.1)
    }
}

/// Position of a point in the camera's frame, and the camera's direction.
#[function]
pub fn seen(camera: &Isometry3<f64>, point: &Point3<f64>) -> (Point3<f64>, Vector3<f64>) {
    let back = camera.inverse();
    (back * point, camera * Vector3::z())
}

/// One pose relative to another, computed in three ways.
#[function]
pub fn relative(one: &Isometry3<f64>, other: &Isometry3<f64>) -> [Isometry3<f64>; 3] {
    [one.inv_mul(other), one.inverse() * other, other / one]
}

/// A pose from its parts, and products with each part on either side.
#[function]
pub fn with_parts(by: &Translation3<f32>, q: &UnitQuaternion<f32>) -> Isometry3<f32> {
    let pose = Isometry3::from_parts(*by, *q);
    let turned = q * pose * q.inverse() / q;
    let moved = by * turned * by.inverse();
    let mut all = (by * q) * (q * by) * moved;
    all *= pose;
    all.translation.vector.x += 1.0;
    all.append_translation_mut(by);
    all.append_rotation_mut(q);
    q / all
}

/// A point and a vector transformed by a pose and back.
#[function]
pub fn there_and_back(pose: &Isometry3<f64>, p: &Point3<f64>, v: &Vector3<f64>) -> (Point3<f64>, Vector3<f64>) {
    let there = pose.transform_point(p) + pose.transform_vector(v);
    (pose.inverse_transform_point(&there), pose.inverse_transform_vector(v))
}

/// The pose as a matrix.
#[function]
pub fn matrix(pose: &Isometry3<f64>) -> Matrix4<f64> {
    pose.to_homogeneous()
}

/// Tests two poses for equality, and returns their distance.
#[function]
pub fn apart(one: Isometry3<f64>, other: Isometry3<f64>) -> (bool, f64) {
    (one == other, (one.translation.vector - other.translation.vector).norm())
}
