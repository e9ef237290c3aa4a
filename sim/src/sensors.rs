//! Real sensors: noise, bias, delay, drop-outs, outliers, individual rates, and resolution.
//!
//! They get the true state and return the readings. They do not know how these are used.

use crate::noise::{Purpose, Stream};
use crate::plant::{State, rotation};
use models::calibration::{Calibration, Echo, Flow, Inertial, Readings, Vicon};
use nalgebra::Vector3;
use std::collections::VecDeque;

/// Quality of one sensor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quality {
    /// Number of control periods between two readings.
    pub every: usize,
    /// Delay of a reading, in control periods.
    pub delay: usize,
    /// Standard deviation of the noise, in the sensor's unit.
    pub noise: f64,
    /// Standard deviation of the bias, constant over a flight, in the same unit.
    pub bias: f64,
    /// Probability that a reading is lost.
    pub lost: f64,
    /// Probability that a reading is an outlier.
    pub nonsense: f64,
}

/// Quality of all sensors.
#[derive(Clone, Debug, PartialEq)]
pub struct Senses {
    /// The gyroscope, rad/s.
    pub gyroscope: Quality,
    /// The accelerometer, m/s².
    pub accelerometer: Quality,
    /// The altimeter, m.
    pub altimeter: Quality,
    /// The camera, m/s.
    pub camera: Quality,
    /// Vicon's position, m.
    pub vicon: Quality,
    /// Noise of Vicon's angles, rad.
    pub vicon_angles: f64,
    /// Intervals in which Vicon does not see the aircraft: start and end, s.
    pub outages: Vec<(f64, f64)>,
}

impl Senses {
    /// The quality of a small quadcopter's sensors, in a room with Vicon.
    pub fn usual() -> Self {
        let every = |every, delay, noise, bias| Quality {
            every,
            delay,
            noise,
            bias,
            lost: 0.01,
            nonsense: 0.0,
        };
        Self {
            gyroscope: every(1, 0, 0.008, 0.01),
            accelerometer: every(1, 0, 0.08, 0.1),
            altimeter: Quality { nonsense: 0.01, ..every(5, 4, 0.008, 0.0) },
            camera: every(4, 2, 0.03, 0.005),
            vicon: Quality { nonsense: 0.002, ..every(2, 2, 0.001, 0.0) },
            vicon_angles: 0.003,
            outages: Vec::new(),
        }
    }

    /// Returns the sensors with noise and biases multiplied by `factor`.
    pub fn scaled(&self, factor: f64) -> Self {
        let mut all = self.clone();
        for quality in [
            &mut all.gyroscope,
            &mut all.accelerometer,
            &mut all.altimeter,
            &mut all.camera,
            &mut all.vicon,
        ] {
            quality.noise *= factor;
            quality.bias *= factor;
        }
        all.vicon_angles *= factor;
        all
    }
}

/// A sensor that can get stuck: it then repeats its last reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stuck {
    /// The gyroscope.
    Gyroscope,
    /// The accelerometer.
    Accelerometer,
    /// The altimeter.
    Altimeter,
    /// Vicon.
    Vicon,
}

/// The sensors of one flight.
#[derive(Clone, Debug)]
pub struct Sensors {
    senses: Senses,
    scales: Calibration,
    gyroscope_bias: Vector3<f64>,
    accelerometer_bias: Vector3<f64>,
    camera_bias: Vector3<f64>,
    past: VecDeque<State>,
    streams: [Stream; 4],
    last: Readings,
    before: State,
    /// True if Vicon is covered, independently of the outages.
    pub blind: bool,
}

impl Sensors {
    /// Creates the sensors with a seed.
    pub fn new(senses: &Senses, seed: u64) -> Self {
        let purposes = [Purpose::Inertial, Purpose::Altimeter, Purpose::Camera, Purpose::Vicon];
        let mut streams = purposes.map(|purpose| Stream::new(seed, purpose));
        let gyroscope_bias = streams[0].normals() * senses.gyroscope.bias;
        let accelerometer_bias = streams[0].normals() * senses.accelerometer.bias;
        let camera_bias = streams[2].normals() * senses.camera.bias;
        Self {
            senses: senses.clone(),
            scales: Calibration::mambo(),
            gyroscope_bias,
            accelerometer_bias,
            camera_bias,
            past: VecDeque::new(),
            streams,
            last: Readings::default(),
            before: State::default(),
            blind: false,
        }
    }

    /// Returns the readings in the control period `n`, which begins at `time`, s.
    pub fn read(
        &mut self,
        n: usize,
        time: f64,
        period: f64,
        state: &State,
        stuck: Option<Stuck>,
    ) -> Readings {
        self.past.push_front(*state);
        self.past.truncate(16);
        let mut readings = Readings {
            inertial: self.inertial(state, period),
            echo: self.echo(n),
            flow: self.flow(n),
            vicon: self.vicon(n, time),
        };
        match stuck {
            Some(Stuck::Gyroscope) => readings.inertial.gyroscope = self.last.inertial.gyroscope,
            Some(Stuck::Accelerometer) => {
                readings.inertial.accelerometer = self.last.inertial.accelerometer;
            }
            Some(Stuck::Altimeter) => readings.echo.delay = self.last.echo.delay,
            Some(Stuck::Vicon) => {
                readings.vicon.position = self.last.vicon.position;
                readings.vicon.angles = self.last.vicon.angles;
            }
            None => {}
        }
        self.remember(&readings);
        self.before = *state;
        readings
    }

    /// Keeps the last reading of each sensor.
    fn remember(&mut self, readings: &Readings) {
        if readings.inertial.fresh {
            self.last.inertial = readings.inertial;
        }
        if readings.echo.fresh {
            self.last.echo = readings.echo;
        }
        if readings.vicon.fresh {
            self.last.vicon = readings.vicon;
        }
    }

    /// Returns the state some periods ago.
    fn earlier(&self, delay: usize) -> State {
        self.past.get(delay).or(self.past.back()).copied().unwrap_or_default()
    }

    fn inertial(&mut self, state: &State, period: f64) -> Inertial {
        let (gyroscope, accelerometer) = (self.senses.gyroscope, self.senses.accelerometer);
        let stream = &mut self.streams[0];
        let fresh = !stream.happens(gyroscope.lost);
        let rates = state.rates + self.gyroscope_bias + stream.normals() * gyroscope.noise;
        let weight = Vector3::new(0.0, 0.0, models::airframe::GRAVITY);
        let felt = (state.velocity - self.before.velocity) / period + weight;
        let force = rotation(&state.angles).transpose() * felt
            + self.accelerometer_bias
            + stream.normals() * accelerometer.noise;
        Inertial {
            fresh,
            gyroscope: counts(&(rates / self.scales.gyroscope_scale)),
            accelerometer: counts(&(force / self.scales.accelerometer_scale)),
        }
    }

    fn echo(&mut self, n: usize) -> Echo {
        let quality = self.senses.altimeter;
        let state = self.earlier(quality.delay);
        let stream = &mut self.streams[1];
        if !n.is_multiple_of(quality.every) || stream.happens(quality.lost) {
            return Echo::default();
        }
        let upright = state.angles.x.cos() * state.angles.y.cos();
        let mut distance = state.position.z / upright.max(0.2) + quality.noise * stream.normal();
        if stream.happens(quality.nonsense) {
            distance = stream.between(0.0, 6.0);
        }
        let delay = 2e6 * distance.max(0.0) / self.scales.sound;
        Echo { fresh: true, delay: delay.round() as u32 }
    }

    fn flow(&mut self, n: usize) -> Flow {
        let quality = self.senses.camera;
        let state = self.earlier(quality.delay);
        let stream = &mut self.streams[2];
        if !n.is_multiple_of(quality.every) || stream.happens(quality.lost) {
            return Flow::default();
        }
        let noise = stream.normals() * quality.noise + self.camera_bias;
        let seen = rotation(&state.angles).transpose() * state.velocity + noise;
        let [x, y, _] = counts(&(seen / self.scales.flow_scale));
        Flow { fresh: true, velocity: [x, y] }
    }

    fn vicon(&mut self, n: usize, time: f64) -> Vicon {
        let quality = self.senses.vicon;
        let state = self.earlier(quality.delay);
        let away = self.senses.outages.iter().any(|(from, to)| (*from..*to).contains(&time));
        let stream = &mut self.streams[3];
        if away || self.blind || !n.is_multiple_of(quality.every) || stream.happens(quality.lost) {
            return Vicon::default();
        }
        let mut position = state.position + stream.normals() * quality.noise;
        let angles = state.angles + stream.normals() * self.senses.vicon_angles;
        if stream.happens(quality.nonsense) {
            // It takes something else for the aircraft.
            position += stream.normals();
        }
        Vicon { fresh: true, position, angles }
    }
}

/// Converts three values to the counts of a 16-bit sensor.
fn counts(values: &Vector3<f64>) -> [i16; 3] {
    [values.x, values.y, values.z].map(|value| value.round() as i16)
}
