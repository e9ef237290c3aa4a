//! A function that the firmware provides in C, with a replacement in Rust for the simulation.

use bessemer::prelude::*;

/// The temperature of a reading, °C, computed by the vendor's library.
#[external(header = "sensor.h", name = "sensor_linear")]
pub fn linear(raw: u16) -> f32 {
    f32::from(raw) * 0.01 - 5.0
}

/// Transforms a reading from the sensor's axes to the body's.
#[external(header = "sensor.h")]
pub fn sensor_axes(raw: &[f32; 3], scale: f32, axes: &mut [f32; 3]) {
    axes[0] = raw[1] * scale;
    axes[1] = raw[0] * scale;
    axes[2] = -raw[2] * scale;
}

/// The mean temperature of two readings, °C.
#[function]
pub fn mean(one: u16, other: u16) -> f32 {
    (linear(one) + linear(other)) / 2.0
}

/// The rates about the axes of the body.
#[function]
pub fn rates(raw: [f32; 3], scale: f32) -> [f32; 3] {
    let mut axes = [0.0; 3];
    sensor_axes(&raw, scale, &mut axes);
    axes
}
