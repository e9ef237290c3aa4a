//! The aircraft's physical parameters (thesis, table A.1), and the forces of its motors (thesis, §2.3).
//!
//! The arrays have room for the largest number of motors. Entries without a motor have coefficients of 0, so sums
//! over all entries are sums over the motors. This module describes the body and contains no gains.

use bessemer::prelude::*;
use core::f64::consts::PI;

/// Largest number of motors: quad-, hexa- and octocopters run the same code.
#[data]
pub const MAX_MOTORS: usize = 8;

/// Acceleration of gravity, m/s².
#[data]
pub const GRAVITY: f64 = 9.81;

/// Arrangement of the arms (thesis, eq. (2.2)).
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Layout {
    /// The first arm points forward.
    Plus,
    /// Two arms straddle the forward direction.
    #[default]
    Cross,
}

/// Mass, size and aerodynamics of a multicopter.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Airframe {
    /// Mass, kg.
    pub mass: f64,
    /// Moments of inertia about the body axes, kg·m².
    pub inertia: Vector3<f64>,
    /// Length of an arm, from the centre of mass to a motor, m.
    pub arm: f64,
    /// Arrangement of the arms.
    pub layout: Layout,
    /// Number of motors: 4, 6 or 8.
    pub motors: usize,
    /// Radius of a propeller, m.
    pub propeller_radius: f64,
    /// Area that a propeller sweeps, m².
    pub disc_area: f64,
    /// Density of the air, kg/m³.
    pub air_density: f64,
    /// Thrust coefficient of each propeller; 0 for a missing motor.
    pub thrust_coefficients: SVector<f64, MAX_MOTORS>,
    /// Drag-moment coefficient of each propeller; 0 for a missing motor.
    pub drag_coefficients: SVector<f64, MAX_MOTORS>,
}

/// Thrust and torque on the body, produced or requested.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// Thrust along the body's z, N.
    pub thrust: f64,
    /// Torque about the body's axes, N·m.
    pub torque: Vector3<f64>,
}

#[data]
impl Airframe {
    /// The Parrot Mambo (thesis, table A.1).
    pub fn mambo() -> Airframe {
        Airframe {
            mass: 0.07,
            inertia: Vector3::new(0.0000582857, 0.0000716914, 0.0001),
            arm: 0.0624,
            layout: Layout::Cross,
            motors: 4,
            propeller_radius: 0.033,
            disc_area: 0.0034,
            air_density: 1.184,
            thrust_coefficients: Airframe::for_each(4, 0.0107),
            drag_coefficients: Airframe::for_each(4, 0.7826e-3),
        }
    }

    /// A hexacopter of the size of the DJI F550, with its battery and a Pixhawk.
    ///
    /// The thesis gives no table for it: mass and arm are the maker's, the propellers are 10 inches
    /// across with the Mambo's coefficients, the inertia is that of six motors of 0.1 kg at the end of
    /// the arms.
    pub fn hexacopter() -> Airframe {
        Airframe {
            mass: 1.6,
            inertia: Vector3::new(0.023, 0.023, 0.045),
            arm: 0.275,
            layout: Layout::Cross,
            motors: 6,
            propeller_radius: 0.127,
            disc_area: 0.0507,
            air_density: 1.184,
            thrust_coefficients: Airframe::for_each(6, 0.0107),
            drag_coefficients: Airframe::for_each(6, 0.7826e-3),
        }
    }

    /// Returns `value` for each of the first `count` motors, and 0 for the rest.
    pub fn for_each(count: usize, value: f64) -> SVector<f64, MAX_MOTORS> {
        let mut all = SVector::zeros();
        for n in 0..MAX_MOTORS {
            if n < count {
                all[n] = value;
            }
        }
        all
    }

    /// Direction in which each motor turns, 1 or −1: neighbours turn against each other.
    pub fn spins(&self) -> SVector<f64, MAX_MOTORS> {
        let mut spins = Airframe::for_each(self.motors, 1.0);
        for n in 0..MAX_MOTORS {
            if n % 2 == 1 {
                spins[n] = -spins[n];
            }
        }
        spins
    }

    /// Thrust of each propeller per square of its speed (thesis, eq. (2.31)), N·s²/rad².
    pub fn thrust_factors(&self) -> SVector<f64, MAX_MOTORS> {
        let area = self.disc_area * self.propeller_radius * self.propeller_radius;
        self.thrust_coefficients * (self.air_density * area)
    }

    /// Drag moment of each propeller per square of its speed (thesis, eq. (2.32)), N·m·s²/rad².
    pub fn drag_factors(&self) -> SVector<f64, MAX_MOTORS> {
        let radius = self.propeller_radius;
        let volume = self.disc_area * radius * radius * radius;
        self.drag_coefficients * (self.air_density * volume)
    }

    /// Thrust and torques from the squares of the motor speeds (thesis, eq. (2.49)).
    ///
    /// Rows: thrust along the body's z; torques about its x (forward), y (left) and z, by the right-hand rule.
    /// Columns: motors, from the forward direction on towards the left. A motor of spin 1 turns the body from x
    /// towards y.
    #[requirement("HLR-11")]
    pub fn effectiveness(&self) -> SMatrix<f64, 4, MAX_MOTORS> {
        let thrust = self.thrust_factors();
        let drag = self.drag_factors();
        let spins = self.spins();
        let mut effect = SMatrix::zeros();
        for n in 0..MAX_MOTORS {
            let (sine, cosine) = arm_angle(self.layout, self.motors, n).sin_cos();
            effect[(0, n)] = thrust[n];
            effect[(1, n)] = thrust[n] * self.arm * sine;
            effect[(2, n)] = -thrust[n] * self.arm * cosine;
            effect[(3, n)] = spins[n] * drag[n];
        }
        effect
    }

    /// Squares of the motor speeds from thrust and torques: the inverse of
    /// [`effectiveness`](Airframe::effectiveness), in closed form (thesis, eq. (3.10)).
    ///
    /// The arms share the thrust evenly, and each torque in proportion to their leverage. It is the
    /// inverse of least squares where the motors are equal; where each has its own coefficients, thrust,
    /// roll and pitch stay exact.
    #[requirement("HLR-11")]
    pub fn allocation(&self) -> SMatrix<f64, MAX_MOTORS, 4> {
        let thrust = self.thrust_factors();
        let drag = self.drag_factors();
        let spins = self.spins();
        let count = self.motors as f64;
        let mut share = SMatrix::zeros();
        for n in 0..MAX_MOTORS {
            if thrust[n] > 0.0 && drag[n] > 0.0 {
                let (sine, cosine) = arm_angle(self.layout, self.motors, n).sin_cos();
                let leverage = 2.0 / (count * thrust[n] * self.arm);
                share[(n, 0)] = 1.0 / (count * thrust[n]);
                share[(n, 1)] = leverage * sine;
                share[(n, 2)] = -leverage * cosine;
                share[(n, 3)] = spins[n] / (count * drag[n]);
            }
        }
        share
    }
}

/// Angle of arm `n` of `count`, counted from 0 (thesis, eq. (2.2)), rad.
#[function]
pub fn arm_angle(layout: Layout, count: usize, n: usize) -> f64 {
    let spacing = 2.0 * PI / count as f64;
    let first = match layout {
        Layout::Plus => 0.0,
        Layout::Cross => spacing / 2.0,
    };
    first + spacing * n as f64
}
