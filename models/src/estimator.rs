//! The state of the aircraft, from all sensors (thesis, §6.1): which source to believe, what
//! to throw away, and one state vector.
//!
//! * Vicon is the source of place and attitude while it is there. Without it: the altimeter for the
//!   height, the camera for the horizontal velocity, the accelerometer for what is level.
//! * A reading out of its sensor's range, not a number, repeated to the bit, or too far from what is
//!   expected (the filters' gates) changes nothing. What lasts is believed in the end: [`DOUBT`].
//! * While an inertial sensor is silent, what it should say stands in for it ([`crate::expectation`]);
//!   without a gyroscope, Vicon or the camera tell what is level.
//! * How long each part of the state has gone unmeasured is told, for others to judge.
//!
//! Knows what the sensors measure, not how the aircraft is flown.

use crate::airframe::GRAVITY;
use crate::attitude_filter::AttitudeFilter;
use crate::axis_filter::AxisFilter;
use crate::calibration::Measured;
use crate::expectation::{Expectation, Push};
use crate::geometry::{Orientation, wrapped};
use crate::low_pass::LowPass;
use crate::signals::Estimate;
use crate::stuck::Stuck;
use bessemer::prelude::*;

/// After so long, s, in which the gates let nothing of a source through, it is the state that is wrong.
#[data]
const DOUBT: f64 = 0.25;

/// The same for the other sources, whose readings are nonsense more often.
#[data]
const LATE_DOUBT: f64 = 0.8;

/// The same while the gyroscope is silent, and the state is wrong more often.
#[data]
const DEAF_DOUBT: f64 = 0.1;

/// So far below the ground, m, it is the height that is wrong: more than the inertial sensors drift in the
/// seconds in which nothing else shows it.
#[data]
const SUNK: f64 = 0.15;

/// How near the ground, m, it may be the ground that holds the aircraft: nothing is expected to fall there.
#[data]
const GROUND: f64 = 0.05;

/// Without the gyroscope for so long, s, its expected readings are all that there is.
#[data]
const DEAF: f64 = 0.02;

/// How uncertain the expected rates are, rad/s, and how they wander, rad/s in a second.
#[data]
const DEAF_RATES: Vector2<f64> = Vector2::new(0.1, 1.0);

/// The same for the acceleration, whose direction is then uncertain, m/s² and m/s² in a second.
#[data]
const DEAF_PUSH: Vector2<f64> = Vector2::new(3.0, 0.02);

/// How uncertain the expected acceleration is, m/s², and how it wanders, m/s² in a second.
#[data]
const UNFELT: Vector2<f64> = Vector2::new(1.0, 0.3);

/// The longest time over which the camera's velocity tells an acceleration, s.
#[data]
const MEMORY: f64 = 0.05;

/// How good the sensors are.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sensors {
    /// Estimation period, s.
    pub period: f64,
    /// Noise of the gyroscope, rad/s, and how its bias wanders, rad/s in a second.
    pub gyroscope: Vector2<f64>,
    /// Noise of the acceleration, m/s², vibration included, and how its bias wanders, m/s² in a second.
    pub accelerometer: Vector2<f64>,
    /// Error of the angles when the specific force is taken for upwards, rad.
    pub level: f64,
    /// Noise of Vicon's position, m, and of its angles, rad.
    pub vicon: Vector2<f64>,
    /// How old Vicon's readings are when they arrive, s.
    pub vicon_delay: f64,
    /// Without Vicon for so long, s, the other sources take over.
    pub vicon_patience: f64,
    /// What Vicon sees, from the ground up: half the sides of a box, m, and its height.
    pub vicon_space: Vector3<f64>,
    /// Noise of the altimeter, m.
    pub altimeter: f64,
    /// Least and largest distance that it measures, m.
    pub altimeter_range: Vector2<f64>,
    /// Least cosine of the tilt at which its echo comes from the ground below.
    pub altimeter_upright: f64,
    /// Noise of the camera's velocity, m/s.
    pub camera: f64,
    /// What is out of so many standard deviations is thrown away.
    pub gate: f64,
    /// Share by which the rates follow the gyroscope in each period: see [`LowPass`].
    pub smoothing: f64,
}

#[data]
impl Sensors {
    /// The Mambo's, and a Vicon of 100 Hz.
    pub fn mambo() -> Sensors {
        Sensors {
            period: 0.005,
            gyroscope: Vector2::new(0.01, 0.0005),
            accelerometer: Vector2::new(0.15, 0.01),
            level: 1.0,
            vicon: Vector2::new(0.002, 0.005),
            vicon_delay: 0.01,
            vicon_patience: 0.1,
            vicon_space: Vector3::new(5.0, 5.0, 5.0),
            altimeter: 0.012,
            altimeter_range: Vector2::new(0.03, 4.0),
            altimeter_upright: 0.85,
            camera: 0.04,
            gate: 5.0,
            smoothing: 0.9,
        }
    }
}

/// How long the parts of the state have gone unmeasured, s.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ages {
    /// Of the inertial sensors.
    pub inertial: f64,
    /// Of Vicon.
    pub vicon: f64,
    /// Of the height, whatever its source.
    pub height: f64,
    /// Of the motion in the plane, whatever its source.
    pub plane: f64,
}

/// The estimator.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Estimator {
    /// Attitude and the gyroscope's biases.
    pub attitude: AttitudeFilter,
    /// Place, velocity and the accelerometer's biases, along each axis.
    pub axes: [AxisFilter; 3],
    /// The rates, without noise.
    pub smooth: LowPass,
    /// Whether Vicon repeats itself.
    pub vicon: Stuck,
    /// Whether the gyroscope repeats itself.
    pub gyroscope: Stuck,
    /// Whether the accelerometer repeats itself.
    pub accelerometer: Stuck,
    /// Whether the altimeter repeats itself.
    pub altimeter: Stuck,
    /// Whether the camera repeats itself.
    pub camera: Stuck,
    /// What the inertial sensors should say.
    pub expectation: Expectation,
    /// The gyroscope's reading or, without one, what it should be, rad/s.
    pub rates: Vector3<f64>,
    /// The accelerometer's likewise, m/s².
    pub force: Vector3<f64>,
    /// Whether that is a reading.
    pub felt: bool,
    /// Vertical acceleration, m/s².
    pub climb: f64,
    /// What the camera saw last, in the inertial frame, m/s.
    pub drift: Vector3<f64>,
    /// How old that is, s.
    pub drift_age: f64,
    /// How old everything is.
    pub ages: Ages,
    /// How many readings were thrown away.
    pub outliers: u32,
}

impl Default for Estimator {
    fn default() -> Self {
        Estimator {
            attitude: AttitudeFilter::level(1.0, 0.05),
            axes: [AxisFilter::at_rest(3.0, 0.3); 3],
            smooth: LowPass::default(),
            vicon: Stuck::default(),
            gyroscope: Stuck::default(),
            accelerometer: Stuck::default(),
            altimeter: Stuck::default(),
            camera: Stuck::default(),
            expectation: Expectation::default(),
            rates: Vector3::zeros(),
            force: Vector3::new(0.0, 0.0, GRAVITY),
            felt: true,
            climb: 0.0,
            drift: Vector3::zeros(),
            drift_age: 0.0,
            ages: Ages::default(),
            outliers: 0,
        }
    }
}

#[component]
impl Estimator {
    /// One period: the state from what was measured in it, and from what the motors were told before it.
    #[entry(infallible)]
    pub fn step(&mut self, sensors: &Sensors, told: &Push, measured: &Measured) -> Estimate {
        self.grow_older(sensors.period);
        self.listen(sensors, told, measured);
        self.advance(sensors);
        if measured.vicon.fresh {
            self.see_vicon(sensors, measured);
        }
        let distance = Vector3::new(measured.distance, 0.0, 0.0);
        let heard = measured.echo && self.altimeter.says(&distance);
        let flow = Vector3::new(measured.flow_velocity.x, measured.flow_velocity.y, 0.0);
        let seen = measured.flow && self.camera.says(&flow);
        if self.ages.vicon > sensors.vicon_patience || self.is_deaf() {
            self.do_without(sensors, measured, heard, seen);
        }
        self.state(sensors)
    }

    /// Everything is one period older until it is measured.
    fn grow_older(&mut self, period: f64) {
        self.ages.inertial += period;
        self.ages.vicon += period;
        self.ages.height += period;
        self.ages.plane += period;
        self.drift_age += period;
    }

    /// Takes in the inertial sensors' readings, and what should have been where there are none.
    fn listen(&mut self, sensors: &Sensors, told: &Push, measured: &Measured) {
        self.expectation.step(sensors.period, told);
        self.felt = measured.inertial && self.accelerometer.says(&measured.force);
        if self.felt {
            self.expectation.felt(&measured.force);
            self.force = measured.force;
        } else {
            self.force = self.expectation.felt_force();
        }
        if measured.inertial && self.gyroscope.says(&measured.rates) {
            self.expectation.turned(&measured.rates);
            self.rates = measured.rates;
            self.ages.inertial = 0.0;
        } else {
            self.rates = self.expectation.rates;
        }
    }

    /// Whether the gyroscope is silent for good.
    #[entry(infallible)]
    pub fn is_deaf(&self) -> bool {
        self.ages.inertial > DEAF
    }

    /// How long the gates may let nothing of the altimeter or of the camera through, s.
    fn patience(&self) -> f64 {
        if self.is_deaf() { DEAF_DOUBT } else { LATE_DOUBT }
    }

    /// Carries the state over one period.
    fn advance(&mut self, sensors: &Sensors) {
        let mut noise = sensors.gyroscope;
        if self.is_deaf() {
            noise = DEAF_RATES;
        }
        self.attitude.predict(&self.rates, sensors.period, noise.x, noise.y);

        let mut noise = sensors.accelerometer;
        if self.is_deaf() {
            noise = DEAF_PUSH;
        } else if !self.felt {
            noise = UNFELT;
        }
        let orientation = Orientation::of(&self.attitude.angles);
        let mut push = orientation.rotation() * self.force - Vector3::new(0.0, 0.0, GRAVITY);
        if !self.felt && self.axes[2].state[0] < GROUND {
            push.z = push.z.max(0.0);
        }
        self.climb = push.z - self.axes[2].state[2];
        for n in 0..3 {
            self.axes[n].predict(push[n], sensors.period, noise.x, noise.y);
        }
        if self.axes[2].state[0] < -SUNK {
            // Nothing falls through the ground.
            self.axes[2].state[0] = -SUNK;
            self.axes[2].state[1] = self.axes[2].state[1].max(0.0);
        }
    }

    /// Takes in Vicon's reading, if it can be one.
    fn see_vicon(&mut self, sensors: &Sensors, measured: &Measured) {
        let vicon = measured.vicon;
        let space = sensors.vicon_space;
        let place = vicon.position;
        let above = place.x.abs() <= space.x && place.y.abs() <= space.y;
        let inside = above && place.z >= -SUNK && place.z <= space.z;
        let new = self.vicon.says(&place);
        if !inside || !new {
            self.outliers = self.outliers.saturating_add(1);
            return;
        }

        let turned = self.see_angles(sensors, &vicon.angles);
        let moved = self.see_place(sensors, &place);
        if turned && moved {
            self.ages.vicon = 0.0;
            self.ages.height = 0.0;
            self.ages.plane = 0.0;
            return;
        }
        self.outliers = self.outliers.saturating_add(1);
        if self.ages.vicon > DOUBT {
            self.doubt();
        }
    }

    /// Vicon's angles, one after another.
    fn see_angles(&mut self, sensors: &Sensors, angles: &Vector3<f64>) -> bool {
        let orientation = Orientation::of(&self.attitude.angles);
        let rates = orientation.angle_rates(&(self.rates - self.attitude.bias));
        let variance = sensors.vicon.y * sensors.vicon.y;
        let everything = Vector6::repeat(1.0);
        let mut good = true;
        for n in 0..3 {
            let then = self.attitude.angles[n] - rates[n] * sensors.vicon_delay;
            let mut row = Vector6::zeros();
            row[n] = 1.0;
            let innovation = wrapped(angles[n] - then);
            good = self.attitude.correct(&row, &everything, innovation, variance, sensors.gate)
                && good;
        }
        good
    }

    /// Vicon's position, axis by axis: what it shows is where the aircraft was a delay ago.
    fn see_place(&mut self, sensors: &Sensors, place: &Vector3<f64>) -> bool {
        let row = Vector3::new(1.0, -sensors.vicon_delay, 0.0);
        let variance = sensors.vicon.x * sensors.vicon.x;
        let mut good = true;
        for n in 0..3 {
            good = self.axes[n].correct(&row, place[n], variance, sensors.gate) && good;
        }
        good
    }

    /// Opens the gates: place and attitude may be anywhere near.
    fn doubt(&mut self) {
        for n in 0..3 {
            self.axes[n].doubt();
            self.attitude.covariance[(n, n)] += 0.1;
        }
    }

    /// The other sources, in Vicon's absence; `heard` and `seen`: whether the altimeter and the camera are
    /// new and alive.
    fn do_without(&mut self, sensors: &Sensors, measured: &Measured, heard: bool, seen: bool) {
        if self.felt && !self.is_deaf() {
            self.level(sensors);
        }
        let orientation = Orientation::of(&self.attitude.angles);
        if heard && !self.see_echo(sensors, measured.distance, &orientation) {
            self.outliers = self.outliers.saturating_add(1);
        }
        if seen && !self.see_flow(sensors, &measured.flow_velocity, &orientation) {
            self.outliers = self.outliers.saturating_add(1);
        }
    }

    /// The altimeter's distance along the body's z, m: whether it was taken.
    fn see_echo(&mut self, sensors: &Sensors, distance: f64, orientation: &Orientation) -> bool {
        let range = sensors.altimeter_range;
        let upright = orientation.c1 * orientation.c2;
        let in_range = distance >= range.x && distance <= range.y;
        if !in_range || upright < sensors.altimeter_upright {
            return false;
        }
        let row = Vector3::new(1.0, 0.0, 0.0);
        let variance = sensors.altimeter * sensors.altimeter;
        let good = self.axes[2].correct(&row, distance * upright, variance, sensors.gate);
        if good {
            self.ages.height = 0.0;
        } else if self.ages.height > self.patience() {
            self.axes[2].doubt();
        }
        good
    }

    /// The camera's velocity along the body's axes, m/s, with what it does not see taken as believed:
    /// whether it was taken.
    fn see_flow(
        &mut self,
        sensors: &Sensors,
        flow: &Vector2<f64>,
        orientation: &Orientation,
    ) -> bool {
        let rotation = orientation.rotation();
        let believed = rotation.tr_mul(&self.velocity());
        let seen = rotation * Vector3::new(flow.x, flow.y, believed.z);
        if self.is_deaf() && self.drift_age < MEMORY {
            self.lean(sensors, &((seen - self.drift) / self.drift_age));
        }
        self.drift = seen;
        self.drift_age = 0.0;
        let row = Vector3::new(0.0, 1.0, 0.0);
        let variance = sensors.camera * sensors.camera;
        let mut good = true;
        for n in 0..2 {
            good = self.axes[n].correct(&row, seen[n], variance, sensors.gate) && good;
        }
        if good {
            self.ages.plane = 0.0;
        } else if self.ages.plane > self.patience() {
            self.axes[0].doubt();
            self.axes[1].doubt();
        }
        good
    }

    /// Takes the specific force for upwards: right on average while the aircraft stays in one place.
    fn level(&mut self, sensors: &Sensors) {
        let Orientation { s3, c3, .. } = Orientation::of(&self.attitude.angles);
        let force = self.force;
        let along = c3 * force.x + s3 * force.y;
        let across = s3 * force.x - c3 * force.y;
        let pitch = along.atan2(force.z);
        let roll = across.atan2(along.hypot(force.z));
        let variance = sensors.level * sensors.level;
        self.see_lean(roll, pitch, variance, sensors.gate);
    }

    /// Takes the direction in which the aircraft is pulled for that of its thrust: what its acceleration in
    /// the plane, m/s², says of roll and pitch while no gyroscope does.
    fn lean(&mut self, sensors: &Sensors, acceleration: &Vector3<f64>) {
        let roll = acceleration.y.atan2(GRAVITY);
        let pitch = (-acceleration.x).atan2(acceleration.y.hypot(GRAVITY));
        let deviation = 1.5 * sensors.camera / (self.drift_age * GRAVITY);
        let variance = deviation * deviation;
        self.see_lean(roll, pitch, variance, sensors.gate);
    }

    /// A measurement of roll and pitch, rad. Of the yaw it says nothing, however uncertain that is.
    fn see_lean(&mut self, roll: f64, pitch: f64, variance: f64, gate: f64) {
        let seen = Vector2::new(roll, pitch);
        let moves = Vector6::new(1.0, 1.0, 0.0, 1.0, 1.0, 0.0);
        for n in 0..2 {
            let mut row = Vector6::zeros();
            row[n] = 1.0;
            let innovation = seen[n] - self.attitude.angles[n];
            self.attitude.correct(&row, &moves, innovation, variance, gate);
        }
    }

    /// The velocity in the inertial frame, m/s.
    fn velocity(&self) -> Vector3<f64> {
        Vector3::new(self.axes[0].state[1], self.axes[1].state[1], self.axes[2].state[1])
    }

    /// Variances of the position, m², and of the angles, rad².
    #[entry(infallible)]
    pub fn spread(&self) -> Vector6<f64> {
        let mut spread = Vector6::zeros();
        for n in 0..3 {
            spread[n] = self.axes[n].covariance[(0, 0)];
            spread[n + 3] = self.attitude.covariance[(n, n)];
        }
        spread
    }

    /// Everything in one vector.
    fn state(&mut self, sensors: &Sensors) -> Estimate {
        let rates = self.rates - self.attitude.bias;
        let axes = self.axes;
        Estimate {
            position: Vector3::new(axes[0].state[0], axes[1].state[0], axes[2].state[0]),
            angles: self.attitude.angles,
            velocity: self.velocity(),
            rates: self.smooth.step(sensors.smoothing, &rates),
        }
    }
}
