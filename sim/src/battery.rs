//! The battery of an aircraft: it counts the charge that the motors draw.
//!
//! It has no influence on the flight, which continues when the battery is empty.

use crate::vehicle::Vehicle;
use nalgebra::SVector;

/// Voltage without a load of a full cell and of an empty one, V: a straight line between them is assumed.
const CELL_VOLTAGES: [f64; 2] = [4.2, 3.4];

/// Power of the propellers as a fraction of the motors' power. It is assumed such that hovering empties the Mambo's
/// battery in about ten minutes, the maker's figure.
const EFFICIENCY: f64 = 0.25;

/// Properties of a battery and of the electronics that it feeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pack {
    /// Charge of a full battery, A·s.
    pub capacity: f64,
    /// Number of cells in series.
    pub cells: f64,
    /// Resistance of cells and wires, Ω.
    pub resistance: f64,
    /// Power of the electronics, W.
    pub electronics: f64,
}

impl Pack {
    /// The Mambo's single cell of 660 mAh; resistance and power are assumed.
    pub fn mambo() -> Self {
        Self { capacity: 0.66 * 3600.0, cells: 1.0, resistance: 0.05, electronics: 0.5 }
    }

    /// The four cells of 5,200 mAh that the F550 flies with; resistance and power are assumed.
    pub fn f550() -> Self {
        Self { capacity: 5.2 * 3600.0, cells: 4.0, resistance: 0.03, electronics: 5.0 }
    }
}

/// A battery.
#[derive(Clone, Debug, PartialEq)]
pub struct Battery {
    pack: Pack,
    /// Moment of each motor per square of its speed, N·m·s²/rad².
    drags: Vec<f64>,
    drawn: f64,
    current: f64,
}

impl Battery {
    /// Creates a full battery for a vehicle.
    pub fn new(vehicle: &Vehicle, pack: Pack) -> Self {
        let drags = vehicle.motors.iter().map(|motor| motor.drag_factor.abs()).collect();
        Self { pack, drags, drawn: 0.0, current: 0.0 }
    }

    /// Draws the charge of a period, s, with the motors at these speeds, rad/s.
    pub fn draw(&mut self, speeds: &SVector<f64, 8>, period: f64) {
        let turning: f64 = self.drags.iter().zip(speeds).map(|(drag, it)| drag * it.powi(3)).sum();
        self.current = (turning / EFFICIENCY + self.pack.electronics) / self.voltage();
        self.drawn = (self.drawn + self.current * period).min(self.pack.capacity);
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
        1.0 - self.drawn / self.pack.capacity
    }

    /// Returns the voltage under load, V.
    pub fn voltage(&self) -> f64 {
        let [full, empty] = CELL_VOLTAGES;
        let cell = empty + (full - empty) * self.left();
        self.pack.cells * cell - self.pack.resistance * self.current
    }
}
