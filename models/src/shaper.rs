//! Shape of the set point: a step becomes a motion with limited speed, acceleration and jerk.
//!
//! The set point moves to the wanted place at the largest speed, in a straight line, and two equal lags smooth it. Each lag is a
//! weighted mean of the past, so no sequence of places makes the shaped point overshoot or exceed a limit. The aircraft
//! and the control law are unknown here.

use bessemer::prelude::*;

/// Largest acceleration behind two equal lags, as a multiple of their rate times the speed: 2/e, which a reversal at full speed
/// reaches.
#[data]
const REVERSAL: f64 = 0.7357588823428847;

/// Largest jerk behind two equal lags, as a multiple of the square of their rate times the speed: 2 (1 + 1/e²).
#[data]
const BEND: f64 = 2.270670566473225;

/// Limits of the shaped set point.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shaping {
    /// True if set points are shaped; false for steps, as in the thesis.
    pub is_active: bool,
    /// Largest speed, m/s.
    pub speed: f64,
    /// Largest acceleration, m/s².
    pub acceleration: f64,
    /// Largest jerk, m/s³.
    pub jerk: f64,
}

#[data]
impl Shaping {
    /// Returns the limits of an aircraft in a room.
    #[requirement("HLR-10")]
    pub fn room() -> Shaping {
        Shaping { is_active: true, speed: 1.5, acceleration: 3.0, jerk: 30.0 }
    }

    /// Returns the rate of the lags at which a reversal at full speed keeps the limits, 1/s.
    #[requirement("HLR-10")]
    pub fn rate(&self) -> f64 {
        let by_acceleration = self.acceleration / (REVERSAL * self.speed);
        let by_jerk = (self.jerk / (BEND * self.speed)).sqrt();
        by_acceleration.min(by_jerk)
    }
}

/// The shaped set point.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shaped {
    /// Position, m.
    pub position: Vector3<f64>,
    /// Velocity, m/s.
    pub velocity: Vector3<f64>,
    /// Acceleration, m/s².
    pub acceleration: Vector3<f64>,
}

/// Shapes the set point.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shaper {
    /// Place that moves to the wanted one at the largest speed, m.
    pub ramp: Vector3<f64>,
    /// The ramp behind the first lag, m.
    pub lagged: Vector3<f64>,
    /// The ramp behind both lags, m.
    pub position: Vector3<f64>,
    /// Velocity of the shaped set point, m/s.
    pub velocity: Vector3<f64>,
}

#[component]
impl Shaper {
    /// Puts the set point to rest at a place, m.
    #[entry(infallible)]
    pub fn rest(&mut self, place: &Vector3<f64>) {
        self.ramp = *place;
        self.lagged = *place;
        self.position = *place;
        self.velocity = Vector3::zeros();
    }

    /// Puts the set point into motion from a place, m, at a velocity, m/s, within the largest speed.
    #[requirement("HLR-10")]
    #[entry(infallible)]
    pub fn begin(&mut self, shaping: &Shaping, place: &Vector3<f64>, velocity: &Vector3<f64>) {
        let speed = velocity.norm();
        let mut moving = *velocity;
        if speed > shaping.speed {
            moving *= shaping.speed / speed;
        }
        let ahead = moving / shaping.rate();
        self.position = *place;
        self.lagged = place + ahead;
        self.ramp = self.lagged + ahead;
        self.velocity = moving;
    }

    /// Advances one period, s, towards the wanted place, m.
    #[requirement("HLR-08", "HLR-10")]
    #[entry(infallible)]
    pub fn step(&mut self, shaping: &Shaping, period: f64, wanted: &Vector3<f64>) -> Shaped {
        if !shaping.is_active {
            self.rest(wanted);
            let still = Vector3::zeros();
            return Shaped { position: *wanted, velocity: still, acceleration: still };
        }
        let way = wanted - self.ramp;
        let distance = way.norm();
        let most = shaping.speed * period;
        if distance > most {
            self.ramp += way * (most / distance);
        } else {
            self.ramp = *wanted;
        }
        let passed = shaping.rate() * period;
        let share = passed / (1.0 + passed);
        let before = self.position;
        self.lagged += (self.ramp - self.lagged) * share;
        self.position += (self.lagged - self.position) * share;
        let velocity = (self.position - before) / period;
        let acceleration = (velocity - self.velocity) / period;
        self.velocity = velocity;
        Shaped { position: self.position, velocity, acceleration }
    }
}
