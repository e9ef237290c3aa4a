//! State estimation from all sensors (thesis, §6.1): selects sources, rejects outliers and returns one state vector.
//!
//! * Vicon is the source of position and attitude while it is available. Without it, the altimeter measures the
//!   height, the camera the horizontal velocity, and the accelerometer the vertical.
//! * A reading that is out of range, not a number, equal to the previous one to the bit, or rejected by the gates
//!   changes nothing. If the gates reject a source for long, the covariance is inflated until they accept it.
//! * While an inertial sensor is silent, its predicted reading is used. Without a gyroscope, Vicon or the camera
//!   measure the attitude.
//! * The age of the measurement of each part of the state is an output.
//!
//! The control of the aircraft is unknown here.

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

/// Time for which the gates reject all of Vicon before the covariance is inflated, s.
#[data]
const VICON_RESET_TIMEOUT: f64 = 0.25;

/// Time for which the gates reject all of another source before the covariance is inflated, s. These sources have more
/// outliers.
#[data]
const RESET_TIMEOUT: f64 = 0.8;

/// Time as above while the gyroscope is lost, s: the state is then wrong more often.
#[data]
const GYRO_LOST_RESET_TIMEOUT: f64 = 0.1;

/// Lowest estimated height below the ground, m. It exceeds the drift of dead reckoning over the seconds in which no
/// sensor measures the height.
#[requirement("HLR-21")]
#[data]
const LOWEST_DEPTH: f64 = 0.15;

/// Height below which the ground may carry the aircraft, m: no downward acceleration is predicted there.
#[data]
const GROUND_CONTACT_HEIGHT: f64 = 0.05;

/// After this time without gyroscope data, s, predicted rates are used.
#[requirement("HLR-24")]
#[data]
const GYRO_TIMEOUT: f64 = 0.02;

/// Standard deviation of the predicted rates, rad/s, and of their drift, rad/s in a second.
#[data]
const PREDICTED_RATE_NOISE: Vector2<f64> = Vector2::new(0.1, 1.0);

/// Standard deviation of the acceleration while the gyroscope is lost, m/s², and of its drift, m/s² in a second. Its
/// direction is then uncertain.
#[data]
const GYRO_LOST_ACCELERATION_NOISE: Vector2<f64> = Vector2::new(3.0, 0.02);

/// Standard deviation of the predicted acceleration, m/s², and of its drift, m/s² in a second.
#[data]
const PREDICTED_ACCELERATION_NOISE: Vector2<f64> = Vector2::new(1.0, 0.3);

/// Longest time over which the camera's velocity is differentiated, s.
#[data]
const FLOW_DIFFERENCE_TIME: f64 = 0.05;

/// Noise and limits of the sensors.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sensors {
    /// Estimation period, s.
    pub period: f64,
    /// Standard deviation of the gyroscope, rad/s, and of its bias drift, rad/s in a second.
    pub gyroscope: Vector2<f64>,
    /// Standard deviation of the acceleration including vibration, m/s², and of its bias drift, m/s² in a second.
    pub accelerometer: Vector2<f64>,
    /// Standard deviation of the tilt that follows from the direction of the specific force, rad.
    pub level: f64,
    /// Standard deviations of Vicon's position, m, and angles, rad.
    pub vicon: Vector2<f64>,
    /// Delay of Vicon's readings, s.
    pub vicon_delay: f64,
    /// After this time without Vicon, s, the other sources are used.
    pub vicon_timeout: f64,
    /// Volume that Vicon covers: half its sides and its height above the ground, m.
    pub vicon_space: Vector3<f64>,
    /// Standard deviation of the altimeter, m.
    pub altimeter: f64,
    /// Range of the altimeter: least and largest distance, m.
    pub altimeter_range: Vector2<f64>,
    /// Least cosine of the tilt at which the altimeter measures the ground below.
    pub altimeter_upright: f64,
    /// Standard deviation of the camera's velocity, m/s.
    pub camera: f64,
    /// Innovation above which a measurement is rejected, in standard deviations.
    pub gate: f64,
    /// Smoothing factor of the rates in each period: the fraction of the difference.
    pub smoothing: f64,
}

#[data]
impl Sensors {
    /// Returns the parameters of the Mambo with a Vicon of 100 Hz.
    pub fn mambo() -> Sensors {
        Sensors {
            period: 0.005,
            gyroscope: Vector2::new(0.01, 0.0005),
            accelerometer: Vector2::new(0.15, 0.01),
            level: 1.0,
            vicon: Vector2::new(0.002, 0.005),
            vicon_delay: 0.01,
            vicon_timeout: 0.1,
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

/// Time since the last measurement of each part of the state, s.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ages {
    /// Age of the inertial measurement.
    pub inertial: f64,
    /// Age of Vicon's measurement.
    pub vicon: f64,
    /// Age of the height measurement, from any source.
    pub height: f64,
    /// Age of the measurement of horizontal motion, from any source.
    pub plane: f64,
}

/// The estimator.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Estimator {
    /// Attitude and the gyroscope's biases.
    pub attitude: AttitudeFilter,
    /// Position, velocity and accelerometer bias along each axis.
    pub axes: [AxisFilter; 3],
    /// Low-pass filter of the rates.
    pub smooth: LowPass,
    /// Stuck detection of Vicon.
    pub vicon: Stuck,
    /// Stuck detection of the gyroscope.
    pub gyroscope: Stuck,
    /// Stuck detection of the accelerometer.
    pub accelerometer: Stuck,
    /// Stuck detection of the altimeter.
    pub altimeter: Stuck,
    /// Stuck detection of the camera.
    pub camera: Stuck,
    /// Predicted readings of the inertial sensors.
    pub expectation: Expectation,
    /// Rates, measured or predicted, rad/s.
    pub rates: Vector3<f64>,
    /// Specific force, measured or predicted, m/s².
    pub force: Vector3<f64>,
    /// True if the specific force is measured.
    pub force_measured: bool,
    /// Vertical acceleration, m/s².
    pub climb: f64,
    /// Last velocity measured by the camera, in the inertial frame, m/s.
    pub flow: Vector3<f64>,
    /// Age of the camera's velocity, s.
    pub flow_age: f64,
    /// Ages of the measurements.
    pub ages: Ages,
    /// Number of rejected measurements.
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
            force_measured: true,
            climb: 0.0,
            flow: Vector3::zeros(),
            flow_age: 0.0,
            ages: Ages::default(),
            outliers: 0,
        }
    }
}

#[component]
impl Estimator {
    /// Advances one period from the measurements and the last motor commands, and returns the estimate.
    #[entry(infallible)]
    pub fn step(&mut self, sensors: &Sensors, commanded: &Push, measured: &Measured) -> Estimate {
        self.advance_ages(sensors.period);
        self.read_inertial(sensors, commanded, measured);
        let orientation = self.advance(sensors);
        if measured.vicon.fresh {
            self.correct_by_vicon(sensors, measured, &orientation);
        }
        let distance = Vector3::new(measured.distance, 0.0, 0.0);
        let echo_is_new = measured.echo && self.altimeter.is_new(&distance);
        let flow = Vector3::new(measured.flow_velocity.x, measured.flow_velocity.y, 0.0);
        let flow_is_new = measured.flow && self.camera.is_new(&flow);
        if self.ages.vicon > sensors.vicon_timeout || self.gyro_lost() {
            self.correct_without_vicon(sensors, measured, echo_is_new, flow_is_new);
        }
        self.state(sensors)
    }

    /// Adds one period to each age.
    fn advance_ages(&mut self, period: f64) {
        self.ages.inertial += period;
        self.ages.vicon += period;
        self.ages.height += period;
        self.ages.plane += period;
        self.flow_age += period;
    }

    /// Reads the inertial sensors, and substitutes predictions for missing readings.
    #[requirement("HLR-22", "HLR-24")]
    fn read_inertial(&mut self, sensors: &Sensors, commanded: &Push, measured: &Measured) {
        self.expectation.step(sensors.period, commanded);
        self.force_measured = measured.inertial && self.accelerometer.is_new(&measured.force);
        if self.force_measured {
            self.expectation.correct_force(&measured.force);
            self.force = measured.force;
        } else {
            self.force = self.expectation.predicted_force();
        }
        if measured.inertial && self.gyroscope.is_new(&measured.rates) {
            self.expectation.correct_rates(&measured.rates);
            self.rates = measured.rates;
            self.ages.inertial = 0.0;
        } else {
            self.rates = self.expectation.rates;
        }
    }

    /// Returns true if the gyroscope is lost.
    #[requirement("HLR-24")]
    #[entry(infallible)]
    pub fn gyro_lost(&self) -> bool {
        self.ages.inertial > GYRO_TIMEOUT
    }

    /// Returns the time for which the gates may reject the altimeter or the camera, s.
    fn reset_timeout(&self) -> f64 {
        if self.gyro_lost() { GYRO_LOST_RESET_TIMEOUT } else { RESET_TIMEOUT }
    }

    /// Predicts the state over one period, and returns the predicted orientation.
    fn advance(&mut self, sensors: &Sensors) -> Orientation {
        let mut noise = sensors.gyroscope;
        if self.gyro_lost() {
            noise = PREDICTED_RATE_NOISE;
        }
        self.attitude.predict(&self.rates, sensors.period, noise.x, noise.y);

        let mut noise = sensors.accelerometer;
        if self.gyro_lost() {
            noise = GYRO_LOST_ACCELERATION_NOISE;
        } else if !self.force_measured {
            noise = PREDICTED_ACCELERATION_NOISE;
        }
        let orientation = Orientation::of(&self.attitude.angles());
        let mut push = orientation.rotation() * self.force - Vector3::new(0.0, 0.0, GRAVITY);
        if !self.force_measured && self.axes[2].state[0] < GROUND_CONTACT_HEIGHT {
            push.z = push.z.max(0.0);
        }
        self.climb = push.z - self.axes[2].state[2];
        for n in 0..3 {
            self.axes[n].predict(push[n], sensors.period, noise.x, noise.y);
        }
        if self.axes[2].state[0] < -LOWEST_DEPTH {
            // The aircraft cannot sink into the ground.
            self.axes[2].state[0] = -LOWEST_DEPTH;
            self.axes[2].state[1] = self.axes[2].state[1].max(0.0);
        }
        orientation
    }

    /// Corrects the state by Vicon's reading, if it is plausible. `orientation` is the predicted one.
    #[requirement("HLR-20", "HLR-21", "HLR-22")]
    fn correct_by_vicon(
        &mut self,
        sensors: &Sensors,
        measured: &Measured,
        orientation: &Orientation,
    ) {
        let vicon = measured.vicon;
        let space = sensors.vicon_space;
        let place = vicon.position;
        let above = place.x.abs() <= space.x && place.y.abs() <= space.y;
        let inside = above && place.z >= -LOWEST_DEPTH && place.z <= space.z;
        let new = self.vicon.is_new(&place);
        if !inside || !new {
            self.outliers = self.outliers.saturating_add(1);
            return;
        }

        let turned = self.correct_angles(sensors, &vicon.angles, orientation);
        let moved = self.correct_position(sensors, &place);
        if turned && moved {
            self.ages.vicon = 0.0;
            self.ages.height = 0.0;
            self.ages.plane = 0.0;
            return;
        }
        self.outliers = self.outliers.saturating_add(1);
        if self.ages.vicon > VICON_RESET_TIMEOUT {
            self.inflate_covariance();
        }
    }

    /// Corrects the attitude by Vicon's angles, one at a time; returns true if all were accepted.
    fn correct_angles(
        &mut self,
        sensors: &Sensors,
        angles: &Vector3<f64>,
        orientation: &Orientation,
    ) -> bool {
        let rates = orientation.angle_rates(&self.attitude.rates(&self.rates));
        let variance = sensors.vicon.y * sensors.vicon.y;
        let mut good = true;
        for n in 0..3 {
            let then = self.attitude.state[n] - rates[n] * sensors.vicon_delay;
            let innovation = wrapped(angles[n] - then);
            good =
                self.attitude.correct(n, &[false; 6], innovation, variance, sensors.gate) && good;
        }
        good
    }

    /// Corrects position and velocity by Vicon's position, axis by axis, allowing for its delay; returns true if all
    /// were accepted.
    fn correct_position(&mut self, sensors: &Sensors, place: &Vector3<f64>) -> bool {
        let row = Vector3::new(1.0, -sensors.vicon_delay, 0.0);
        let variance = sensors.vicon.x * sensors.vicon.x;
        let mut good = true;
        for n in 0..3 {
            good = self.axes[n].correct(&row, place[n], variance, sensors.gate) && good;
        }
        good
    }

    /// Inflates the covariances of position, velocity and attitude.
    fn inflate_covariance(&mut self) {
        for n in 0..3 {
            self.axes[n].inflate();
            self.attitude.covariance.elements[(n, n)] += 0.1;
        }
    }

    /// Corrects the state by the sources that replace Vicon. `echo_is_new` and `flow_is_new` say which of them
    /// delivered.
    #[requirement("HLR-23")]
    fn correct_without_vicon(
        &mut self,
        sensors: &Sensors,
        measured: &Measured,
        echo_is_new: bool,
        flow_is_new: bool,
    ) {
        if self.force_measured && !self.gyro_lost() {
            self.tilt_from_force(sensors);
        }
        let orientation = Orientation::of(&self.attitude.angles());
        if echo_is_new && !self.correct_height(sensors, measured.distance, &orientation) {
            self.outliers = self.outliers.saturating_add(1);
        }
        if flow_is_new && !self.correct_velocity(sensors, &measured.flow_velocity, &orientation) {
            self.outliers = self.outliers.saturating_add(1);
        }
    }

    /// Corrects the height by the altimeter's distance along the body's z, m; returns true if it was accepted.
    #[requirement("HLR-21", "HLR-23")]
    fn correct_height(
        &mut self,
        sensors: &Sensors,
        distance: f64,
        orientation: &Orientation,
    ) -> bool {
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
        } else if self.ages.height > self.reset_timeout() {
            self.axes[2].inflate();
        }
        good
    }

    /// Corrects the horizontal velocity by the camera's velocity along the body's axes, m/s; returns true if it was
    /// accepted. The vertical velocity is the estimate.
    #[requirement("HLR-23")]
    fn correct_velocity(
        &mut self,
        sensors: &Sensors,
        flow: &Vector2<f64>,
        orientation: &Orientation,
    ) -> bool {
        let rotation = orientation.rotation();
        let believed = rotation.tr_mul(&self.velocity());
        let seen = rotation * Vector3::new(flow.x, flow.y, believed.z);
        if self.gyro_lost() && self.flow_age < FLOW_DIFFERENCE_TIME {
            self.tilt_from_acceleration(sensors, &((seen - self.flow) / self.flow_age));
        }
        self.flow = seen;
        self.flow_age = 0.0;
        let row = Vector3::new(0.0, 1.0, 0.0);
        let variance = sensors.camera * sensors.camera;
        let mut good = true;
        for n in 0..2 {
            good = self.axes[n].correct(&row, seen[n], variance, sensors.gate) && good;
        }
        if good {
            self.ages.plane = 0.0;
        } else if self.ages.plane > self.reset_timeout() {
            self.axes[0].inflate();
            self.axes[1].inflate();
        }
        good
    }

    /// Corrects roll and pitch by the direction of the specific force, which is vertical on average while the aircraft
    /// hovers.
    fn tilt_from_force(&mut self, sensors: &Sensors) {
        let Orientation { s3, c3, .. } = Orientation::of(&self.attitude.angles());
        let force = self.force;
        let along = c3 * force.x + s3 * force.y;
        let across = s3 * force.x - c3 * force.y;
        let pitch = along.atan2(force.z);
        let roll = across.atan2(along.hypot(force.z));
        let variance = sensors.level * sensors.level;
        self.correct_tilt(roll, pitch, variance, sensors.gate);
    }

    /// Corrects roll and pitch by the horizontal acceleration, m/s², which has the direction of the thrust, while the
    /// gyroscope is lost.
    fn tilt_from_acceleration(&mut self, sensors: &Sensors, acceleration: &Vector3<f64>) {
        let roll = acceleration.y.atan2(GRAVITY);
        let pitch = (-acceleration.x).atan2(acceleration.y.hypot(GRAVITY));
        let deviation = 1.5 * sensors.camera / (self.flow_age * GRAVITY);
        let variance = deviation * deviation;
        self.correct_tilt(roll, pitch, variance, sensors.gate);
    }

    /// Corrects roll and pitch by a measurement of both, rad. The yaw does not change.
    fn correct_tilt(&mut self, roll: f64, pitch: f64, variance: f64, gate: f64) {
        let seen = Vector2::new(roll, pitch);
        let considered = [false, false, true, false, false, true];
        for n in 0..2 {
            let innovation = seen[n] - self.attitude.state[n];
            self.attitude.correct(n, &considered, innovation, variance, gate);
        }
    }

    /// Returns the velocity in the inertial frame, m/s.
    fn velocity(&self) -> Vector3<f64> {
        Vector3::new(self.axes[0].state[1], self.axes[1].state[1], self.axes[2].state[1])
    }

    /// Returns the variances of the position, m², and of the angles, rad².
    #[entry(infallible)]
    pub fn variances(&self) -> Vector6<f64> {
        let mut variances = Vector6::zeros();
        for n in 0..3 {
            variances[n] = self.axes[n].covariance.elements[(0, 0)];
            variances[n + 3] = self.attitude.covariance.elements[(n, n)];
        }
        variances
    }

    /// Returns the estimate.
    fn state(&mut self, sensors: &Sensors) -> Estimate {
        let rates = self.attitude.rates(&self.rates);
        let axes = self.axes;
        Estimate {
            position: Vector3::new(axes[0].state[0], axes[1].state[0], axes[2].state[0]),
            angles: self.attitude.angles(),
            velocity: self.velocity(),
            rates: self.smooth.step(sensors.smoothing, &rates),
        }
    }
}
