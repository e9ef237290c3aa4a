//! The battery of the Mambo: it counts the charge that the motors draw.
//!
//! It has no influence on the flight, which continues when the battery is empty.

use crate::vehicle::Vehicle;
use nalgebra::SVector;

/// Charge of a full battery (the maker's 660 mAh), A·s.
const CAPACITY: f64 = 0.66 * 3600.0;

/// Voltage without a load of a full cell and of an empty one, V: a straight line between them is assumed.
const VOLTAGES: [f64; 2] = [4.2, 3.4];

/// Resistance of cell and wires, Ω: assumed.
const RESISTANCE: f64 = 0.05;

/// Power of the propellers as a fraction of the motors' power. It is assumed such that hovering empties the battery in
/// about ten minutes, the maker's figure.
const EFFICIENCY: f64 = 0.25;

/// Power of the electronics, W: assumed.
const ELECTRONICS: f64 = 0.5;

/// A battery.
#[derive(Clone, Debug, PartialEq)]
pub struct Battery {
    /// Moment of each motor per square of its speed, N·m·s²/rad².
    drags: Vec<f64>,
    drawn: f64,
    current: f64,
}

impl Battery {
    /// Creates a full battery for a vehicle.
    pub fn new(vehicle: &Vehicle) -> Self {
        let drags = vehicle.motors.iter().map(|motor| motor.drag_factor.abs()).collect();
        Self { drags, drawn: 0.0, current: 0.0 }
    }

    /// Draws the charge of a period, s, with the motors at these speeds, rad/s.
    pub fn draw(&mut self, speeds: &SVector<f64, 8>, period: f64) {
        let turning: f64 = self.drags.iter().zip(speeds).map(|(drag, it)| drag * it.powi(3)).sum();
        self.current = (turning / EFFICIENCY + ELECTRONICS) / self.voltage();
        self.drawn = (self.drawn + self.current * period).min(CAPACITY);
    }

    /// Returns the current, A.
    pub fn current(&self) -> f64 {
        self.current
    }

    /// Returns the charge drawn, A·s.
    pub fn drawn(&self) -> f64 {
        self.drawn
    }

    /// Returns the remaining charge, from 1 down to 0.
    pub fn left(&self) -> f64 {
        1.0 - self.drawn / CAPACITY
    }

    /// Returns the voltage under load, V.
    pub fn voltage(&self) -> f64 {
        let [full, empty] = VOLTAGES;
        empty + (full - empty) * self.left() - RESISTANCE * self.current
    }
}
