//! The aircraft's sensors: packet sensors of `bessemer_sim`, with the quantities of this aircraft, their errors, and counts.
//!
//! They get the true state and return the readings. They do not know how these are used.

use crate::noise::{Purpose, Stream};
use crate::plant::{Body, State, rotation_of};
use bessemer_sim::{Delivery, Instrument, Numbers, PacketSensor, Period, Plant, Reading, View};
pub use bessemer_sim::{Fault, FaultKind};
use models::calibration::{Calibration, Echo, Flow, Inertial, Readings, Vicon};
use nalgebra::Vector3;
use std::num::NonZeroU32;

/// Quality of one sensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Rate, age and losses of its packets, in control periods.
    pub delivery: Delivery,
    /// Standard deviation of the noise, in the sensor's unit.
    pub noise: f64,
    /// Standard deviation of the bias, constant over a flight, in the same unit.
    pub bias: f64,
    /// Probability that a reading is an outlier.
    pub outliers: f64,
}

/// Quality of all sensors.
#[derive(Clone, Debug, PartialEq)]
pub struct Senses {
    /// The gyroscope, rad/s.
    pub gyroscope: Quality,
    /// The accelerometer, m/s². It is in the gyroscope's packet, and has its delivery.
    pub accelerometer: Quality,
    /// The altimeter, m.
    pub altimeter: Quality,
    /// The camera, m/s.
    pub camera: Quality,
    /// Vicon's position, m.
    pub vicon: Quality,
    /// Noise of Vicon's angles, rad.
    pub vicon_angles: f64,
}

impl Senses {
    /// The quality of a small quadcopter's sensors, in a room with Vicon.
    pub fn usual() -> Self {
        let every = |ticks, age, noise, bias| {
            let period = Period::from(NonZeroU32::new(ticks).unwrap_or(NonZeroU32::MIN));
            let delivery = Delivery { period, age, dropout: 0.01 };
            Quality { delivery, noise, bias, outliers: 0.0 }
        };
        Self {
            gyroscope: every(1, 0, 0.008, 0.01),
            accelerometer: every(1, 0, 0.08, 0.1),
            altimeter: Quality { outliers: 0.01, ..every(5, 4, 0.008, 0.0) },
            camera: every(4, 2, 0.03, 0.005),
            vicon: Quality { outliers: 0.002, ..every(2, 2, 0.001, 0.0) },
            vicon_angles: 0.003,
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

/// The truth that sensors see.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    /// State of the aircraft.
    pub state: State,
    /// Rotation of the aircraft: the rows of [`rotation`](crate::plant::rotation).
    pub rotation: [[f64; 3]; 3],
}

impl Seen {
    /// Returns the truth in a state.
    pub fn of(state: &State) -> Self {
        Self { state: *state, rotation: rotation_of(state.angles.into()) }
    }

    fn of_view<P: Plant<12>>(view: &View<'_, P, 12>) -> Self {
        Self::of(&State::from_vector(view.state))
    }

    /// Returns a vector of the inertial frame in the body frame.
    fn inside(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        let [a, b, c] = self.rotation;
        Vector3::from_fn(|n, _| a[n] * vector.x + b[n] * vector.y + c[n] * vector.z)
    }
}

/// A sensor that can fail alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sensor {
    /// The gyroscope.
    Gyroscope,
    /// The accelerometer.
    Accelerometer,
    /// The altimeter.
    Altimeter,
    /// The camera.
    Camera,
    /// Vicon.
    Vicon,
}

impl Sensor {
    /// Returns the name by which faults find the sensor.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gyroscope => "gyroscope",
            Self::Accelerometer => "accelerometer",
            Self::Altimeter => "altimeter",
            Self::Camera => "camera",
            Self::Vicon => "vicon",
        }
    }

    /// Returns a fault of the sensor between two times, s.
    pub fn fault(self, kind: FaultKind, from: f64, until: f64) -> Fault {
        Fault { sensor: self.name().to_owned(), from, until, kind }
    }
}

/// The sensors of one flight.
#[derive(Clone, Debug)]
pub struct Sensors {
    scales: Calibration,
    inertial: PacketSensor<InertialUnit, 6>,
    altimeter: PacketSensor<Altimeter, 1>,
    camera: PacketSensor<Camera, 3>,
    vicon: PacketSensor<MotionCapture, 6>,
}

impl Sensors {
    /// Creates the sensors, which are read with a period in s, with a seed.
    pub fn new(senses: &Senses, period: f64, seed: u64) -> Self {
        let chance = |purpose: Purpose| Stream::new(seed, purpose);
        let unit = InertialUnit::new(senses, period, chance(Purpose::Inertial));
        let names = [Sensor::Gyroscope, Sensor::Accelerometer].map(|sensor| [sensor.name(); 3]);
        let [[a, b, c], [d, e, f]] = names;
        // The unit draws its losses itself: it has noise in lost packets, too.
        let delivery = Delivery { dropout: 0.0, ..senses.gyroscope.delivery };
        let inertial = PacketSensor::new([a, b, c, d, e, f], unit.0, delivery, unit.1);

        let altimeter = PacketSensor::new(
            [Sensor::Altimeter.name()],
            Altimeter(senses.altimeter),
            senses.altimeter.delivery,
            chance(Purpose::Altimeter),
        );
        let mut stream = chance(Purpose::Camera);
        let bias = stream.normals() * senses.camera.bias;
        let camera = PacketSensor::new(
            [Sensor::Camera.name(); 3],
            Camera { noise: senses.camera.noise, bias },
            senses.camera.delivery,
            stream,
        );
        let vicon = PacketSensor::new(
            [Sensor::Vicon.name(); 6],
            MotionCapture { position: senses.vicon, angles: senses.vicon_angles },
            senses.vicon.delivery,
            chance(Purpose::Vicon),
        );
        Self { scales: Calibration::mambo(), inertial, altimeter, camera, vicon }
    }

    /// Returns the readings in the control period `n`; `fault` returns the present fault of a sensor by its name.
    pub(crate) fn read(
        &mut self,
        n: u64,
        seen: &Seen,
        fault: impl Fn(&str) -> Option<FaultKind>,
    ) -> Readings {
        let scales = &self.scales;
        let inertial = read(&mut self.inertial, n, |it| it.truth(seen), &fault);
        let mut readings = Readings {
            inertial: Inertial {
                fresh: inertial.is_fresh,
                gyroscope: counts(&(first(&inertial.value) / scales.gyroscope_scale)),
                accelerometer: counts(&(second(&inertial.value) / scales.accelerometer_scale)),
            },
            ..Readings::default()
        };
        let altimeter = read(&mut self.altimeter, n, |_| Altimeter::truth(seen), &fault);
        if altimeter.is_fresh {
            let delay = 2e6 * altimeter.value.x.max(0.0) / scales.sound;
            readings.echo = Echo { fresh: true, delay: delay.round() as u32 };
        }
        let camera = read(&mut self.camera, n, |_| seen.inside(&seen.state.velocity), &fault);
        if camera.is_fresh {
            let [x, y, _] = counts(&(camera.value / scales.flow_scale));
            readings.flow = Flow { fresh: true, velocity: [x, y] };
        }
        let vicon = read(&mut self.vicon, n, |_| MotionCapture::truth(seen), &fault);
        if vicon.is_fresh {
            let (position, angles) = (first(&vicon.value), second(&vicon.value));
            readings.vicon = Vicon { fresh: true, position, angles };
        }
        readings
    }
}

/// Reads a sensor whose truth is known already.
fn read<I: Instrument<Body, 12, M>, const M: usize>(
    sensor: &mut PacketSensor<I, M>,
    n: u64,
    truth: impl FnOnce(&mut I) -> Numbers<M>,
    fault: &impl Fn(&str) -> Option<FaultKind>,
) -> Reading<Numbers<M>> {
    sensor.read_truth::<Body, 12>(n, truth, fault)
}

/// Gyroscope, rad/s, and accelerometer, m/s².
#[derive(Clone, Debug)]
struct InertialUnit {
    /// Period between two readings, s.
    period: f64,
    /// Velocity at the last reading, m/s.
    before: Vector3<f64>,
    bias: Numbers<6>,
    noise: Numbers<6>,
    dropout: f64,
}

impl InertialUnit {
    /// Draws the biases; returns the unit and its chance.
    fn new(senses: &Senses, period: f64, mut chance: Stream) -> (Self, Stream) {
        let (gyroscope, accelerometer) = (senses.gyroscope, senses.accelerometer);
        let each = |gyroscope, accelerometer| {
            joined(&Vector3::repeat(gyroscope), &Vector3::repeat(accelerometer))
        };
        let bias = chance.normals::<6>().component_mul(&each(gyroscope.bias, accelerometer.bias));
        let noise = each(gyroscope.noise, accelerometer.noise);
        let dropout = gyroscope.delivery.dropout;
        (Self { period, before: Vector3::zeros(), bias, noise, dropout }, chance)
    }
}

impl InertialUnit {
    fn truth(&mut self, seen: &Seen) -> Numbers<6> {
        let State { velocity, rates, .. } = seen.state;
        let weight = Vector3::new(0.0, 0.0, models::airframe::GRAVITY);
        let felt = (velocity - self.before) / self.period + weight;
        self.before = velocity;
        joined(&rates, &seen.inside(&felt))
    }
}

impl<P: Plant<12>> Instrument<P, 12, 6> for InertialUnit {
    fn measure(&mut self, view: &View<'_, P, 12>) -> Numbers<6> {
        self.truth(&Seen::of_view(view))
    }

    fn packet(&mut self, truth: Numbers<6>, chance: &mut Stream) -> Option<Numbers<6>> {
        let is_lost = chance.happens(self.dropout);
        let noisy = truth + self.bias + chance.normals::<6>().component_mul(&self.noise);
        (!is_lost).then_some(noisy)
    }
}

/// Distance to the ground along the body's z, m.
#[derive(Clone, Debug)]
struct Altimeter(Quality);

impl Altimeter {
    fn truth(seen: &Seen) -> Numbers<1> {
        // The cosine of the tilt.
        let upright = seen.rotation[2][2];
        [seen.state.position.z / upright.max(0.2)].into()
    }
}

impl<P: Plant<12>> Instrument<P, 12, 1> for Altimeter {
    fn measure(&mut self, view: &View<'_, P, 12>) -> Numbers<1> {
        Self::truth(&Seen::of_view(view))
    }

    fn packet(&mut self, truth: Numbers<1>, chance: &mut Stream) -> Option<Numbers<1>> {
        let noisy = truth + chance.normals() * self.0.noise;
        let is_outlier = chance.happens(self.0.outliers);
        Some(if is_outlier { [chance.between(0.0, 6.0)].into() } else { noisy })
    }
}

/// Velocity in the body frame, m/s, of which the camera sees x and y.
#[derive(Clone, Debug)]
struct Camera {
    noise: f64,
    bias: Vector3<f64>,
}

impl<P: Plant<12>> Instrument<P, 12, 3> for Camera {
    fn measure(&mut self, view: &View<'_, P, 12>) -> Numbers<3> {
        let seen = Seen::of_view(view);
        seen.inside(&seen.state.velocity)
    }

    fn packet(&mut self, truth: Numbers<3>, chance: &mut Stream) -> Option<Numbers<3>> {
        Some(truth + (chance.normals() * self.noise + self.bias))
    }
}

/// Position in the inertial frame, m, and Euler angles, rad.
#[derive(Clone, Debug)]
struct MotionCapture {
    position: Quality,
    /// Noise of the angles, rad.
    angles: f64,
}

impl MotionCapture {
    fn truth(seen: &Seen) -> Numbers<6> {
        joined(&seen.state.position, &seen.state.angles)
    }
}

impl<P: Plant<12>> Instrument<P, 12, 6> for MotionCapture {
    fn measure(&mut self, view: &View<'_, P, 12>) -> Numbers<6> {
        Self::truth(&Seen::of_view(view))
    }

    fn packet(&mut self, truth: Numbers<6>, chance: &mut Stream) -> Option<Numbers<6>> {
        let mut position = first(&truth) + chance.normals() * self.position.noise;
        let angles = second(&truth) + chance.normals() * self.angles;
        if chance.happens(self.position.outliers) {
            // It takes something else for the aircraft.
            position += chance.normals();
        }
        Some(joined(&position, &angles))
    }
}

fn joined(first: &Vector3<f64>, second: &Vector3<f64>) -> Numbers<6> {
    [first.x, first.y, first.z, second.x, second.y, second.z].into()
}

fn first(numbers: &Numbers<6>) -> Vector3<f64> {
    numbers.fixed_rows::<3>(0).into_owned()
}

fn second(numbers: &Numbers<6>) -> Vector3<f64> {
    numbers.fixed_rows::<3>(3).into_owned()
}

/// Converts three values to the counts of a 16-bit sensor.
fn counts(values: &Vector3<f64>) -> [i16; 3] {
    [values.x, values.y, values.z].map(|value| value.round() as i16)
}
