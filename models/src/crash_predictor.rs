//! Whether the flight is about to end badly (thesis, §6.1): limits on what is known of the aircraft now
//! and a moment ahead, and on how well it is known.
//!
//! It judges the state alone, not what may have caused it. Once raised, an alarm stays until `init`: the
//! motors stop, and somebody goes and looks.

use crate::airframe::GRAVITY;
use crate::estimator::Ages;
use crate::geometry::Orientation;
use crate::signals::Estimate;
use bessemer::prelude::*;

/// For so many periods something has to look wrong: one reading proves nothing.
#[data]
const PROOF: u32 = 3;

/// Below this height, m, an aircraft that does not know how it leans had better go on landing.
#[data]
const LOW: f64 = 0.2;

/// What is wrong.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Alarm {
    /// Nothing.
    #[default]
    Clear,
    /// The ground asked for the motors to stop.
    Asked,
    /// The state is not a number.
    Undefined,
    /// The processor's clock does not go forward as it should.
    Clock,
    /// A part of the state has gone unmeasured for too long.
    Blind,
    /// The aircraft leans too far, or will.
    Tilt,
    /// It turns too fast.
    Spin,
    /// It moves too fast, or will.
    Speed,
    /// It is too high, or will be.
    Height,
    /// It is too far away, or will be.
    Place,
    /// It will hit the ground too hard.
    Impact,
}

/// What is out of bounds.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// Largest tilt, rad.
    pub tilt: f64,
    /// Fastest turn about the body's x and y, and about its z, rad/s.
    pub rates: Vector2<f64>,
    /// Largest speed, m/s.
    pub speed: f64,
    /// Largest height, m.
    pub ceiling: f64,
    /// Largest distance from the start along x and along y, m.
    pub reach: f64,
    /// Fastest touch-down, m/s.
    pub impact: f64,
    /// Longest time without a measurement of the height or of the motion in the plane, s: as long as the
    /// inertial sensors carry the state.
    pub blind: f64,
    /// Without the gyroscope and Vicon the camera alone shows how the aircraft leans: longest time without
    /// it, s.
    pub dizzy: f64,
    /// How far ahead to look, s.
    pub horizon: f64,
    /// Whether to stop the motors: off, the predictor only watches.
    pub armed: bool,
}

#[data]
impl Limits {
    /// Limits for flights in a room.
    pub fn room() -> Limits {
        Limits {
            tilt: 0.9,
            rates: Vector2::new(12.0, 12.0),
            speed: 4.0,
            ceiling: 4.0,
            reach: 4.0,
            impact: 0.7,
            blind: 20.0,
            dizzy: 0.1,
            horizon: 0.1,
            armed: true,
        }
    }
}

/// The crash predictor.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CrashPredictor {
    /// The first thing that went wrong.
    pub alarm: Alarm,
    /// For how many periods something has looked wrong.
    pub suspicion: u32,
}

#[component]
impl CrashPredictor {
    /// One period: what has gone wrong so far. Only what flies can crash. `climb`: the vertical
    /// acceleration, m/s².
    #[entry(infallible)]
    pub fn step(
        &mut self,
        limits: &Limits,
        flying: bool,
        estimate: &Estimate,
        ages: &Ages,
        climb: f64,
    ) -> Alarm {
        if flying && limits.armed && self.alarm == Alarm::Clear {
            let found = CrashPredictor::find(limits, estimate, ages, climb);
            self.suspicion = self.suspicion.saturating_add(1);
            if found == Alarm::Clear {
                self.suspicion = 0;
            }
            if found == Alarm::Undefined || self.suspicion >= PROOF {
                self.alarm = found;
            }
        }
        self.alarm
    }

    /// Raises an alarm that is not found in the state.
    #[entry(infallible)]
    pub fn raise(&mut self, alarm: Alarm) {
        if self.alarm == Alarm::Clear {
            self.alarm = alarm;
        }
    }

    /// What is wrong now, or will be within the horizon.
    fn find(limits: &Limits, now: &Estimate, ages: &Ages, climb: f64) -> Alarm {
        let sum = now.position.norm() + now.angles.norm() + now.velocity.norm() + now.rates.norm();
        if !sum.is_finite() {
            return Alarm::Undefined;
        }
        let unaided = ages.inertial > limits.dizzy && ages.vicon > limits.dizzy;
        let dizzy = unaided && ages.plane > limits.dizzy && now.position.z > LOW;
        if dizzy || ages.height > limits.blind || ages.plane > limits.blind {
            return Alarm::Blind;
        }
        let mut horizon = limits.horizon;
        if unaided {
            // The rates are a guess, and so is what they lead to.
            horizon *= 0.3;
        }
        let across = now.rates.x.hypot(now.rates.y);
        if across > limits.rates.x || now.rates.z.abs() > limits.rates.y {
            return Alarm::Spin;
        }
        let orientation = Orientation::of(&now.angles);
        let ahead = now.angles + orientation.angle_rates(&now.rates) * horizon;
        let upright = limits.tilt.cos();
        if tilt_cosine(&now.angles) < upright || tilt_cosine(&ahead) < upright {
            return Alarm::Tilt;
        }
        CrashPredictor::find_in_motion(limits, now, &orientation, climb, horizon)
    }

    /// What is wrong with where the aircraft goes.
    fn find_in_motion(
        limits: &Limits,
        now: &Estimate,
        orientation: &Orientation,
        climb: f64,
        horizon: f64,
    ) -> Alarm {
        let place = now.position + now.velocity * horizon;
        // In the plane the thrust that holds the weight pulls to where the aircraft leans.
        let direction = orientation.thrust_direction();
        let pull = Vector3::new(direction.x, direction.y, 0.0) * GRAVITY;
        let velocity = now.velocity + pull * horizon;
        if now.velocity.norm() > limits.speed || velocity.norm() > limits.speed {
            return Alarm::Speed;
        }
        if now.position.z > limits.ceiling || place.z > limits.ceiling {
            return Alarm::Height;
        }
        if place.x.abs() > limits.reach || place.y.abs() > limits.reach {
            return Alarm::Place;
        }
        let gained = climb * horizon;
        let low = place.z + 0.5 * gained * horizon;
        if low < 0.0 && now.velocity.z + gained < -limits.impact {
            return Alarm::Impact;
        }
        Alarm::Clear
    }
}

/// Cosine of the angle between the body's z and the inertial frame's.
#[function]
fn tilt_cosine(angles: &Vector3<f64>) -> f64 {
    angles.x.cos() * angles.y.cos()
}
