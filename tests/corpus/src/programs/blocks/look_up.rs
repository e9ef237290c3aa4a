//! Tables of an engine: ignition by speed and load, and a sensor's curve.

use bessemer::prelude::*;
pub use bessemer_blocks::{Axis, Beyond, Search, UniformAxis, ascends, interpolated, interpolated_2d};

/// Speeds of the table's rows, 1/min.
const SPEEDS: Axis<f32, 4> = Axis { points: [800.0, 1500.0, 3000.0, 6000.0] };
/// Loads of the table's columns.
const LOADS: UniformAxis<f32, 3> = UniformAxis { first: 0.0, spacing: 0.5 };
/// Advance of the ignition, °.
#[data]
pub static ADVANCE: [[f32; 3]; 4] =
    [[5.0, 4.0, 2.0], [12.0, 9.0, 6.0], [26.0, 20.0, 15.0], [30.0, 25.0, 20.0]];

/// Looks up the ignition's advance.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ignition {
    speed: Search,
}

#[component]
impl Ignition {
    /// Returns the advance, °.
    #[entry(infallible)]
    pub fn step(&mut self, speed: f32, load: f32) -> f32 {
        let row = self.speed.place(&SPEEDS, speed, Beyond::Hold);
        interpolated_2d(&ADVANCE, row, LOADS.place(load, Beyond::Hold))
    }
}

/// The value of a calibrated curve, extended beyond its ends; 0 if the curve is not one.
#[function]
pub fn calibrated(curve: &Axis<f64, 5>, values: &[f64; 5], input: f64) -> f64 {
    if !ascends(&curve.points) {
        return 0.0;
    }
    interpolated(values, curve.place(input, Beyond::Extend))
}

/// The value of a uniform table, extended beyond its ends.
#[function]
pub fn uniform(values: &[f64; 4], first: f64, spacing: f64, input: f64) -> f64 {
    let axis = UniformAxis::<f64, 4> { first, spacing };
    interpolated(values, axis.place(input, Beyond::Extend))
}
