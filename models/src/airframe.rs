//! The aircraft in figures (thesis, table A.1), and what its four motors do to it.
//!
//! Knows the body, not how it is flown: no gain belongs here.

use bessemer::prelude::*;
use core::f64::consts::PI;

/// Mass, size and aerodynamics of a quadcopter in `x` configuration.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Airframe {
    /// Mass, kg.
    pub mass: f64,
    /// Moments of inertia about the body axes, kg·m².
    pub inertia: Vector3<f64>,
    /// Length of an arm, from the centre of mass to a motor, m.
    pub arm: f64,
    /// Radius of a propeller, m.
    pub propeller_radius: f64,
    /// Area that a propeller sweeps, m².
    pub disc_area: f64,
    /// Density of the air, kg/m³.
    pub air_density: f64,
    /// Direction in which each motor turns, 1 or −1: neighbours turn against each other.
    pub spins: Vector4<f64>,
    /// Thrust coefficient of a propeller.
    pub thrust_coefficient: f64,
    /// Drag-moment coefficient of a propeller.
    pub drag_coefficient: f64,
}

#[data]
impl Airframe {
    /// The Parrot Mambo (thesis, table A.1).
    pub fn mambo() -> Airframe {
        Airframe {
            mass: 0.07,
            inertia: Vector3::new(0.0000582857, 0.0000716914, 0.0001),
            arm: 0.0624,
            propeller_radius: 0.033,
            disc_area: 0.0034,
            air_density: 1.184,
            spins: Vector4::new(1.0, -1.0, 1.0, -1.0),
            thrust_coefficient: 0.0107,
            drag_coefficient: 0.7826e-3,
        }
    }

    /// Thrust of a propeller per square of its speed (thesis, eq. (2.31)), N·s²/rad².
    pub fn thrust_factor(&self) -> f64 {
        let area = self.disc_area * self.propeller_radius * self.propeller_radius;
        self.air_density * area * self.thrust_coefficient
    }

    /// Drag moment of a propeller per square of its speed (thesis, eq. (2.32)), N·m·s²/rad².
    pub fn drag_factor(&self) -> f64 {
        let radius = self.propeller_radius;
        let volume = self.disc_area * radius * radius * radius;
        self.air_density * volume * self.drag_coefficient
    }

    /// Thrust and torques from the squares of the motor speeds (thesis, eq. (2.49)).
    ///
    /// Rows: thrust, roll, pitch, yaw. Columns: motors.
    pub fn effectiveness(&self) -> Matrix4<f64> {
        let thrust = self.thrust_factor();
        let drag = self.drag_factor();
        let mut effect = Matrix4::zeros();
        for n in 0..4 {
            let angle = arm_angle(n);
            effect[(0, n)] = thrust;
            effect[(1, n)] = thrust * self.arm * angle.sin();
            effect[(2, n)] = -thrust * self.arm * angle.cos();
            effect[(3, n)] = self.spins[n] * drag;
        }
        effect
    }

    /// Squares of the motor speeds from thrust and torques: the inverse of
    /// [`effectiveness`](Airframe::effectiveness), in closed form (thesis, eq. (3.10)).
    ///
    /// The arms share the thrust evenly, and each torque in proportion to their leverage.
    pub fn allocation(&self) -> Matrix4<f64> {
        let thrust = self.thrust_factor();
        let drag = self.drag_factor();
        let mut share = Matrix4::zeros();
        for n in 0..4 {
            let angle = arm_angle(n);
            share[(n, 0)] = 1.0 / (4.0 * thrust);
            share[(n, 1)] = angle.sin() / (2.0 * thrust * self.arm);
            share[(n, 2)] = -angle.cos() / (2.0 * thrust * self.arm);
            share[(n, 3)] = self.spins[n] / (4.0 * drag);
        }
        share
    }
}

/// Angle of arm `n` of four in `x` configuration, counted from 0 (thesis, eq. (2.2)), rad.
#[function]
pub fn arm_angle(n: usize) -> f64 {
    n as f64 * PI / 2.0 + PI / 4.0
}
