//! Conversion of sensor readings to physical units: offsets and scales (thesis, §6.1, signal processor).
//!
//! Scales follow the data sheets; plausibility is checked by the estimator. Readings of the processor's own sensors
//! are counts and cannot be NaN; Vicon's are received by radio and can be any number.

use bessemer::prelude::*;

/// Largest count of a 16-bit sensor: a reading of this count is saturated.
#[requirement("HLR-21")]
#[data]
const FULL_SCALE: i16 = 32767;

/// Raw reading of the inertial sensors.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inertial {
    /// True if the reading is new.
    pub fresh: bool,
    /// Angular velocity about the body's axes, counts.
    pub gyroscope: [i16; 3],
    /// Specific force along the body's axes, counts.
    pub accelerometer: [i16; 3],
}

/// Raw reading of the ultrasonic altimeter.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Echo {
    /// True if the reading is new.
    pub fresh: bool,
    /// Time from the pulse to its echo, µs.
    pub delay: u32,
}

/// Raw reading of the optical-flow camera, which looks down.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Flow {
    /// True if the reading is new.
    pub fresh: bool,
    /// Velocity along the body's x and y, counts.
    pub velocity: [i16; 2],
}

/// Reading of Vicon, received by radio.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vicon {
    /// True if the reading is new.
    pub fresh: bool,
    /// Position in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Roll, pitch and yaw, rad.
    pub angles: Vector3<f64>,
}

/// All sensor readings of one period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Readings {
    /// The inertial sensors.
    pub inertial: Inertial,
    /// The altimeter.
    pub echo: Echo,
    /// The camera.
    pub flow: Flow,
    /// Vicon.
    pub vicon: Vicon,
}

/// All sensor readings of one period in physical units.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// True if the inertial reading is new and not saturated.
    pub inertial: bool,
    /// Angular velocity in the body frame, rad/s.
    pub rates: Vector3<f64>,
    /// Specific force in the body frame, m/s².
    pub force: Vector3<f64>,
    /// True if the altimeter's reading is new.
    pub echo: bool,
    /// Distance to the ground along the body's z, m.
    pub distance: f64,
    /// True if the camera's reading is new and not saturated.
    pub flow: bool,
    /// Velocity along the body's x and y, m/s.
    pub flow_velocity: Vector2<f64>,
    /// Reading of Vicon, unchanged.
    pub vicon: Vicon,
}

/// Calibration of the sensors, from their data sheets and measurements at rest.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Calibration {
    /// Angular velocity per count, rad/s.
    pub gyroscope_scale: f64,
    /// Angular velocity at rest, rad/s.
    pub gyroscope_offset: Vector3<f64>,
    /// Specific force per count, m/s².
    pub accelerometer_scale: f64,
    /// Specific force in free fall, m/s².
    pub accelerometer_offset: Vector3<f64>,
    /// Speed of sound, m/s.
    pub sound: f64,
    /// Velocity of the camera per count, m/s.
    pub flow_scale: f64,
}

#[data]
impl Calibration {
    /// Returns the calibration for a gyroscope of ±2000 °/s, an accelerometer of ±8 g and a camera in mm/s.
    pub fn mambo() -> Calibration {
        Calibration {
            gyroscope_scale: 2000.0_f64.to_radians() / 32768.0,
            gyroscope_offset: Vector3::zeros(),
            accelerometer_scale: 8.0 * 9.80665 / 32768.0,
            accelerometer_offset: Vector3::zeros(),
            sound: 343.0,
            flow_scale: 0.001,
        }
    }

    /// Converts the readings of one period to physical units.
    #[requirement("HLR-21")]
    pub fn measured(&self, readings: &Readings) -> Measured {
        let inertial = readings.inertial;
        let flow = readings.flow;
        let rates = vector(&inertial.gyroscope) * self.gyroscope_scale;
        let force = vector(&inertial.accelerometer) * self.accelerometer_scale;
        let in_range = within(&inertial.gyroscope) && within(&inertial.accelerometer);
        let forward = flow.velocity[0];
        let sideways = flow.velocity[1];
        Measured {
            inertial: inertial.fresh && in_range,
            rates: rates - self.gyroscope_offset,
            force: force - self.accelerometer_offset,
            echo: readings.echo.fresh,
            distance: f64::from(readings.echo.delay) * 1e-6 * self.sound / 2.0,
            flow: flow.fresh && inside(forward) && inside(sideways),
            flow_velocity: Vector2::new(f64::from(forward), f64::from(sideways)) * self.flow_scale,
            vicon: readings.vicon,
        }
    }
}

/// Returns three counts as a vector.
#[function]
fn vector(counts: &[i16; 3]) -> Vector3<f64> {
    Vector3::new(f64::from(counts[0]), f64::from(counts[1]), f64::from(counts[2]))
}

/// Returns true if no count is saturated.
#[function]
fn within(counts: &[i16; 3]) -> bool {
    inside(counts[0]) && inside(counts[1]) && inside(counts[2])
}

/// Returns true if a count is not saturated.
#[requirement("HLR-21")]
#[function]
fn inside(count: i16) -> bool {
    count < FULL_SCALE && count > -FULL_SCALE
}
