//! Feed-forward that emulates another gravity or air (thesis, ch. 4): motor speeds that cancel the aircraft's own
//! dynamics, and their gain over time.
//!
//! The compensator computes the speeds that cancel all of weight and friction; the gain selects the injected
//! fraction. Thrust is proportional to the square of the speed, so a gain γ cancels γ² of the weight. (4.22)–(4.25)
//! yield no thrust as printed and are not used.

use crate::airframe::{Airframe, GRAVITY, MAX_MOTORS};
use crate::geometry::Orientation;
use bessemer::prelude::*;

/// Growth of the gain from 0 to its final value.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Profile {
    /// The gain has its final value from the start.
    #[default]
    Constant,
    /// In proportion to the time since its beginning (thesis, eq. (7.1)).
    Linear,
    /// Growth along a sigmoid (thesis, eq. (7.11)).
    Sigmoid,
}

/// Parameters of the feed-forward.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Injection {
    /// Growth of the gain.
    pub profile: Profile,
    /// Start of the growth, in seconds since take-off: T of (7.1).
    pub begins: f64,
    /// K_slope of (7.1): the growth of the gain from T to 2 T.
    pub slope: f64,
    /// a of (7.11), 1/s: negative.
    pub rate: f64,
    /// b of (7.11).
    pub offset: f64,
    /// c of (7.11).
    pub power: f64,
    /// Final value of the gain.
    pub most: f64,
    /// Friction to cancel, N·s/m; negative to add friction.
    pub friction: f64,
}

#[data]
impl Injection {
    /// No feed-forward.
    pub fn none() -> Injection {
        Injection {
            profile: Profile::Constant,
            begins: 0.0,
            slope: 0.0,
            rate: 0.0,
            offset: 0.0,
            power: 1.0,
            most: 0.0,
            friction: 0.0,
        }
    }

    /// Returns a gain that is constant.
    pub fn constant(most: f64) -> Injection {
        Injection { begins: 10.0, most, ..Injection::none() }
    }

    /// Returns the gain at which the effective gravity is `gravity`, m/s².
    pub fn gain_for(gravity: f64) -> f64 {
        (1.0 - gravity / GRAVITY).max(0.0).sqrt()
    }

    /// Returns a gain that grows in proportion to time.
    pub fn linear(most: f64) -> Injection {
        let profile = Profile::Linear;
        Injection { profile, begins: 10.0, slope: 0.2, most, ..Injection::none() }
    }

    /// Returns a gain that grows along a sigmoid.
    ///
    /// a and b cannot be read in the thesis. These have the gain at 1 % of K at 10 s, at half of it at
    /// 28 s, and at 0.7 at 32 s, where it is cut off.
    pub fn sigmoid(most: f64) -> Injection {
        let profile = Profile::Sigmoid;
        let fit = Injection { profile, rate: -0.25, offset: 7.0, power: 1.04, ..Injection::none() };
        Injection { begins: 10.0, most, ..fit }
    }

    /// Returns the gain at a time since take-off, s.
    #[requirement("HLR-18")]
    pub fn gain(&self, time: f64) -> f64 {
        if time < self.begins {
            return 0.0;
        }
        let grown = match self.profile {
            Profile::Constant => self.most,
            Profile::Linear => self.slope * (time - self.begins) / self.begins,
            Profile::Sigmoid => {
                (1.0 / (1.0 + (self.rate * time + self.offset).exp())).powf(self.power)
            }
        };
        grown.max(0.0).min(self.most)
    }
}

/// Returns the speed of each motor that carries the weight at the present tilt and cancels `friction`, rad/s (thesis,
/// eqs. (4.7), (4.16)–(4.21)).
///
/// `airframe` is the aircraft as it is believed to be: its coefficients are what the identification finds.
#[requirement("HLR-18")]
#[function]
pub fn compensation(
    airframe: &Airframe,
    orientation: &Orientation,
    velocity: &Vector3<f64>,
    friction: f64,
) -> SVector<f64, MAX_MOTORS> {
    let weight = orientation.upwards().z * airframe.mass * GRAVITY;
    let drag = orientation.thrust_direction().dot(velocity) * friction;
    let each = ((weight + drag) / airframe.motors as f64).max(0.0);
    let factors = airframe.thrust_factors();
    let mut speeds = SVector::zeros();
    for n in 0..MAX_MOTORS {
        if factors[n] > 0.0 {
            speeds[n] = (each / factors[n]).sqrt();
        }
    }
    speeds
}
