//! A multicopter with any number of motors: their forces and torques (thesis, §2.3).
//!
//! Knows forces and torques in the body frame, not motion.

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
                place: airframe.arm * Vector3::new(angle.cos(), angle.sin(), 0.0),
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
        let mut thrust = 0.0;
        let mut torque = Vector3::zeros();
        for (motor, square) in self.motors.iter().zip(squares) {
            let lift = motor.thrust_factor * square;
            thrust += lift;
            torque += motor.place.cross(&Vector3::new(0.0, 0.0, lift));
            torque.z += motor.drag_factor * square;
        }
        (thrust, torque)
    }
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
