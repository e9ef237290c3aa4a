//! The aircraft of the testbed: airframe, settings of the onboard software, motors, battery and air of each.
//!
//! Knows no flight: scenarios and the ground station choose an aircraft and fly it.

use crate::battery::{Battery, Pack};
use crate::vehicle::Vehicle;
use models::{Airframe, Settings};

/// An aircraft of the testbed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Aircraft {
    /// The Parrot Mambo, a quadcopter of 70 g.
    #[default]
    Mambo,
    /// A hexacopter of the size of the DJI F550.
    F550,
}

impl Aircraft {
    /// Every aircraft.
    pub const ALL: [Self; 2] = [Self::Mambo, Self::F550];

    /// Returns the name of the aircraft in commands and recordings.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mambo => "mambo",
            Self::F550 => "f550",
        }
    }

    /// Returns the aircraft of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|it| it.name() == name)
    }

    /// Returns the number by which the onboard program knows the aircraft.
    pub fn number(self) -> u64 {
        match self {
            Self::Mambo => 0,
            Self::F550 => 1,
        }
    }

    /// Returns the airframe.
    pub fn airframe(self) -> Airframe {
        match self {
            Self::Mambo => Airframe::mambo(),
            Self::F550 => Airframe::hexacopter(),
        }
    }

    /// Returns the settings of the onboard software.
    pub fn settings(self) -> Settings {
        match self {
            Self::Mambo => Settings::mambo(),
            Self::F550 => Settings::hexacopter(),
        }
    }

    /// Returns the time constant of the motors, s.
    pub fn lag(self) -> f64 {
        match self {
            Self::Mambo => 0.015,
            Self::F550 => 0.04,
        }
    }

    /// Returns the standard deviation of the gusts in a room, N.
    pub fn gusts(self) -> f64 {
        match self {
            Self::Mambo => 0.001,
            Self::F550 => 0.1,
        }
    }

    /// Returns the largest force of the wind that fault injection offers, N: 4 % of the weight.
    pub fn wind(self) -> f64 {
        match self {
            Self::Mambo => 0.03,
            Self::F550 => 0.7,
        }
    }

    /// Returns the largest speed of a motor, rad/s.
    pub fn fastest(self) -> f64 {
        let mixer = self.settings().parameters.mixer;
        (mixer.square_per_command * mixer.largest_command).sqrt()
    }

    /// Returns a full battery.
    pub fn battery(self) -> Battery {
        let pack = match self {
            Self::Mambo => Pack::mambo(),
            Self::F550 => Pack::f550(),
        };
        Battery::new(&Vehicle::new(&self.airframe()), pack)
    }
}
