//! Reproducible random numbers: a stream for each purpose, all from one seed.
//!
//! Invariant: a stream depends only on the seed and its own number, so that a new sensor, or another thread, changes
//! nothing for the others.

use nalgebra::Vector3;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

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

/// A stream of random numbers.
#[derive(Clone, Debug)]
pub struct Stream(ChaCha8Rng);

impl Stream {
    /// Creates the stream of a purpose from a seed.
    pub fn new(seed: u64, purpose: Purpose) -> Self {
        let mut chacha = ChaCha8Rng::seed_from_u64(seed);
        chacha.set_stream(purpose as u64);
        Self(chacha)
    }

    /// Returns a normally distributed number with a standard deviation of 1.
    pub fn normal(&mut self) -> f64 {
        self.0.sample(StandardNormal)
    }

    /// Returns three normally distributed numbers.
    pub fn normals(&mut self) -> Vector3<f64> {
        Vector3::new(self.normal(), self.normal(), self.normal())
    }

    /// Returns a uniformly distributed number between two limits.
    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.0.random::<f64>()
    }

    /// Returns a whole number from 0 to below `count`.
    pub fn below(&mut self, count: u64) -> u64 {
        self.0.next_u64() % count
    }

    /// Returns true with this probability.
    pub fn happens(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }
}
