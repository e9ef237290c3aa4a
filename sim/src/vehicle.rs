//! A multicopter with any number of motors: their forces and torques (thesis, §2.3).
//!
//! Knows forces and torques in the body frame, not motion.

use bessemer::math::ElementaryMethods;
use bessemer_lanes::Number;
use models::{Airframe, Layout};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// One motor with its propeller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motor {
    /// Position in the body frame, m.
    pub place: Vector3<f64>,
    /// Thrust per square of speed, N·s²/rad².
    pub thrust_factor: f64,
    /// Moment about the body's z per square of speed, with its sign, N·m·s²/rad².
    pub drag_factor: f64,
}

/// A rigid body with motors.
#[derive(Clone, Debug, PartialEq)]
pub struct Vehicle {
    /// Mass, kg.
    pub mass: f64,
    /// Moments of inertia about the body axes, kg·m².
    pub inertia: Vector3<f64>,
    /// The motors, in the order of the arms.
    pub motors: Vec<Motor>,
}

impl Vehicle {
    /// Creates the vehicle of an airframe; neighbouring motors rotate in opposite directions.
    pub fn new(airframe: &Airframe) -> Self {
        let radius = airframe.propeller_radius;
        let pressure = airframe.air_density * airframe.disc_area * radius.powi(2);
        let motor = |n: usize| {
            let spin = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
            let angle = arm_angle(airframe.layout, airframe.motors, n);
            Motor {
                place: airframe.arm * Vector3::new(angle.dsl_cos(), angle.dsl_sin(), 0.0),
                thrust_factor: pressure * airframe.thrust_coefficients[n],
                drag_factor: spin * pressure * radius * airframe.drag_coefficients[n],
            }
        };
        Self {
            mass: airframe.mass,
            inertia: airframe.inertia,
            motors: (0..airframe.motors).map(motor).collect(),
        }
    }

    /// Creates the Parrot Mambo.
    pub fn mambo() -> Self {
        Self::new(&Airframe::mambo())
    }

    /// Thrust along the body's z, N, and torque about the body's axes, N·m, at the given squares
    /// of the motor speeds, rad²/s² (thesis, eq. (2.49)).
    pub fn loads(&self, squares: &[f64]) -> (f64, Vector3<f64>) {
        assert!(squares.len() >= self.motors.len(), "one speed per motor");
        let motors = self.motors.iter().map(Motor::numbers).zip(squares.iter().copied());
        let (thrust, torque) = loads(motors);
        (thrust, torque.into())
    }
}

impl Motor {
    /// Returns place along x and y, and the factors of thrust and drag.
    pub(crate) fn numbers(&self) -> [f64; 4] {
        [self.place.x, self.place.y, self.thrust_factor, self.drag_factor]
    }
}

/// Returns thrust, N, and torque, N·m, of motors by their [`Motor::numbers`] and the squares of their speeds, rad²/s².
pub(crate) fn loads<T: Number>(motors: impl Iterator<Item = ([T; 4], T)>) -> (T, [T; 3]) {
    let zero = T::of(0.0);
    let (mut thrust, mut torque) = (zero, [zero; 3]);
    for ([x, y, thrust_factor, drag_factor], square) in motors {
        let lift = thrust_factor * square;
        thrust = thrust + lift;
        torque[0] = torque[0] + y * lift;
        torque[1] = torque[1] - x * lift;
        torque[2] = torque[2] + drag_factor * square;
    }
    (thrust, torque)
}

/// Angle of arm `n`, counted from 0 (thesis, eq. (2.2)), rad.
pub fn arm_angle(layout: Layout, count: usize, n: usize) -> f64 {
    let spacing = 2.0 * PI / count as f64;
    let first = match layout {
        Layout::Plus => 0.0,
        Layout::Cross => spacing / 2.0,
    };
    first + spacing * n as f64
}
