//! Tables of parameters with axes, which a calibration tool sees as a curve and as a map.

use bessemer::prelude::*;
use bessemer_blocks::{Axis, Beyond, interpolated, interpolated_2d};

/// Tables of an engine.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Maps {
    /// Speeds.
    #[unit("1/min")]
    pub speeds: Axis<f32, 4>,
    /// Loads.
    pub loads: Axis<f32, 3>,
    /// Torque at full load by speed.
    #[axes(speeds)]
    #[unit("N·m")]
    pub full: [f32; 4],
    /// Ignition by speed and load.
    #[axes(speeds, loads)]
    #[c(name = "ignition_deg")]
    pub ignition: [[f32; 3]; 4],
    /// Steps of a lever.
    pub steps: [i16; 2],
    /// Gain by step.
    #[axes(steps)]
    #[range(0..=50)]
    pub gains: [u8; 2],
}

/// An engine's tables.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Engine {
    /// The last torque.
    pub torque: f32,
}

#[component]
impl Engine {
    /// Looks up ignition and torque.
    #[entry]
    pub fn step(&mut self, maps: &Maps, speed: f32, load: f32, lever: i16) -> f32 {
        let at = maps.speeds.place(speed, Beyond::Hold);
        self.torque = interpolated(&maps.full, at);
        let gain = if lever > maps.steps[0] { maps.gains[1] } else { maps.gains[0] };
        interpolated_2d(&maps.ignition, at, maps.loads.place(load, Beyond::Extend)) * f32::from(gain)
    }
}
