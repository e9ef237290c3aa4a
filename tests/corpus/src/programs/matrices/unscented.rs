//! Filters without a derivative: a vehicle in the plane by its distances to two beacons, with a covariance and with its root.

use bessemer::prelude::*;
use bessemer_estimation::{Correction, Rooted, Status, Symmetric, unscented};

/// Places of the beacons, m.
pub const BEACONS: [[f64; 2]; 2] = [[0.0, 0.0], [10.0, 0.0]];

/// Place, m, and heading, rad, of a vehicle.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, State)]
pub struct Pose {
    /// Place in the plane, m.
    pub place: Vector2<f64>,
    /// Heading from the first axis, rad.
    pub heading: f64,
}

/// The pose after a distance, m, and a turn, rad.
#[function]
fn driven(pose: &Vector3<f64>, distance: f64, turn: f64) -> Vector3<f64> {
    let (sine, cosine) = (pose[2] + 0.5 * turn).sin_cos();
    pose + Vector3::new(distance * cosine, distance * sine, turn)
}

/// Distances to the beacons, m.
#[function]
fn distances(pose: &Vector3<f64>) -> Vector2<f64> {
    let mut distances = Vector2::zeros();
    for n in 0..2 {
        let (x, y) = (pose[0] - BEACONS[n][0], pose[1] - BEACONS[n][1]);
        distances[n] = (x * x + y * y).sqrt();
    }
    distances
}

/// An unscented filter.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Located {
    /// Pose.
    pub pose: Pose,
    /// Covariance of its errors.
    pub covariance: Symmetric<f64, 3>,
}

impl Default for Located {
    fn default() -> Self {
        Located {
            pose: Pose { place: Vector2::new(2.0, 3.0), heading: 0.0 },
            covariance: Symmetric::diagonal(&Vector3::new(1.0, 1.0, 0.1)),
        }
    }
}

#[component]
impl Located {
    /// Drives a distance, m, with a turn, rad; returns true unless the covariance lost its sign.
    #[entry(infallible)]
    pub fn drive(&mut self, distance: f64, turn: f64) -> bool {
        let moved = unscented(&self.pose.vector(), &self.covariance, 3.0, |pose| driven(pose, distance, turn));
        match moved {
            Some(next) => {
                self.pose = Pose::of_vector(&next.mean);
                self.covariance = next.covariance;
                self.covariance.add_diagonal(&Vector3::new(1e-4, 1e-4, 1e-5));
                true
            }
            None => false,
        }
    }

    /// Corrects by measured distances to the beacons, m.
    #[entry(infallible)]
    pub fn measure(&mut self, measured: &Vector2<f64>) -> Correction<f64> {
        let mut pose = self.pose.vector();
        match unscented(&pose, &self.covariance, 3.0, |pose| distances(pose)) {
            Some(expected) => {
                let noise = Symmetric::diagonal(&Vector2::new(0.01, 0.01));
                let report = self.covariance.correct_unscented(&mut pose, &expected, measured, &noise, 30.0);
                self.pose = Pose::of_vector(&pose);
                report
            }
            None => Correction { surprise: 0.0, status: Status::Lost },
        }
    }
}

/// An unscented filter by the root of its covariance.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct LocatedByRoot {
    /// Place, m, and heading, rad.
    pub pose: Vector3<f64>,
    /// Root of the covariance of their errors.
    pub root: Rooted<f64, 3>,
}

impl Default for LocatedByRoot {
    fn default() -> Self {
        LocatedByRoot {
            pose: Vector3::new(2.0, 3.0, 0.0),
            root: Rooted::diagonal(&Vector3::new(1.0, 1.0, 0.3)),
        }
    }
}

#[component]
impl LocatedByRoot {
    /// Drives a distance, m, with a turn, rad, and corrects by the distance to the first beacon, m.
    #[entry(infallible)]
    pub fn step(&mut self, distance: f64, turn: f64, measured: f64) -> Correction<f64> {
        let noise = Vector3::new(0.01, 0.01, 0.003);
        self.root.predict_unscented(&mut self.pose, 3.0, &noise, |pose| driven(pose, distance, turn));
        self.root.correct_unscented(&mut self.pose, 3.0, measured, 0.01, 30.0, |pose| distances(pose)[0])
    }

    /// Corrects by a measured heading, rad, and grows by a known jump along the first axis, m.
    #[entry(infallible)]
    pub fn head(&mut self, innovation: f64, jump: f64) -> Matrix3<f64> {
        let row = Vector3::new(0.0, 0.0, 1.0);
        let report = self.root.correct(&mut self.pose, &row, innovation, 0.01, 9.0);
        if report.status == Status::Corrected {
            self.root.add(&Vector3::new(jump, 0.0, 0.0));
        }
        *self.root.covariance().matrix()
    }
}
