//! Reproducible random numbers: a stream for each purpose, all from one seed.

pub use bessemer_sim::Stream;

/// Purpose of a random stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The inertial sensors.
    Inertial = 1,
    /// The altimeter.
    Altimeter,
    /// The camera.
    Camera,
    /// Vicon.
    Vicon,
    /// The wind.
    Wind,
    /// Differences between the flights of a campaign.
    Dice,
    /// The particles of a swarm.
    Swarm,
    /// Faults of a link.
    Radio,
}

impl From<Purpose> for u64 {
    fn from(purpose: Purpose) -> u64 {
        purpose as u64
    }
}
