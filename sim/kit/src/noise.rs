//! Chance by seed: each sample of each channel has numbers of its own.
//!
//! A number depends on the seed, the channel's name, the number of the sample and its purpose, and on nothing else. So a
//! new sensor, or another order of the sensors, changes nothing for the others. The generator is ChaCha with 8 rounds; the normal
//! distribution of [`Chance`] is that of Box and Muller, by the functions of `libm`, so the bits are equal on every machine.
//!
//! A process of your own, such as wind, or draws before a run take a [`Stream`]: numbers in sequence, independent of those of other streams.

use std::f64::consts::TAU;

use nalgebra::SVector;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

/// Words of 32 bits that are reserved for a sample: a block of ChaCha.
const BLOCK: u128 = 16;

/// Numbers of 64 bits in a block.
const NUMBERS: usize = 8;

/// Random numbers of a channel.
#[derive(Clone, Debug)]
pub struct Chance(ChaCha8Rng);

impl Chance {
    /// Creates the numbers of a channel from a seed.
    pub fn new(seed: u64, channel: &str) -> Self {
        let mut generator = ChaCha8Rng::seed_from_u64(seed);
        generator.set_stream(hash(channel));
        Self(generator)
    }

    /// Returns four independent numbers of a sample, each uniform from 0 to below 1.
    pub fn uniform(&mut self, sample: u64) -> [f64; 4] {
        let [a, b, c, d, ..] = self.block(sample);
        [a, b, c, d]
    }

    /// Returns two independent numbers of a sample, normal with mean 0 and variance 1, and one uniform from 0 to below 1.
    pub fn normal(&mut self, sample: u64) -> ([f64; 2], f64) {
        let [radius, angle, uniform, ..] = self.block(sample);
        (normals(radius, angle), uniform)
    }

    /// Returns all independent numbers of a sample of a sensor.
    pub(crate) fn draws(&mut self, sample: u64) -> Draws {
        let [radius, angle, lost, outlier, size, ..] = self.block(sample);
        let [white, walk] = normals(radius, angle);
        Draws { white, walk, lost, outlier, size: 2.0 * size - 1.0 }
    }

    /// Returns the independent numbers of a sample, each uniform from 0 to below 1.
    fn block(&mut self, sample: u64) -> [f64; NUMBERS] {
        self.0.set_word_pos(u128::from(sample) * BLOCK);
        // The upper 53 bits.
        std::array::from_fn(|_| (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// Numbers of one sample of a sensor.
pub(crate) struct Draws {
    /// Normal: the white noise.
    pub white: f64,
    /// Normal: the step of the bias.
    pub walk: f64,
    /// Uniform from 0 to below 1: the sample is lost if it is below the probability.
    pub lost: f64,
    /// Uniform from 0 to below 1: the sample is an outlier if it is below the probability.
    pub outlier: f64,
    /// Uniform from −1 to below 1: the size of the outlier.
    pub size: f64,
}

/// Returns two independent normal numbers from two uniform ones.
fn normals(radius: f64, angle: f64) -> [f64; 2] {
    let radius = (-2.0 * libm::log(1.0 - radius)).sqrt();
    let (sine, cosine) = libm::sincos(TAU * angle);
    [radius * cosine, radius * sine]
}

/// Numbers in sequence, which depend on the seed, the stream's number and how many were drawn before.
///
/// Normal numbers are those of the crate `rand_distr`: the method of Marsaglia and Tsang, about a third of the cost of [`Chance`].
///
/// ```
/// use bessemer_sim::Stream;
/// let (mut wind, mut again) = (Stream::new(7, 1_u64), Stream::new(7, 1_u64));
/// assert_eq!(wind.normal(), again.normal());
/// assert_ne!(wind.normal(), Stream::new(7, 2_u64).normal());
/// assert!((0.0..6.0).contains(&wind.between(0.0, 6.0)));
/// ```
#[derive(Clone, Debug)]
pub struct Stream(ChaCha8Rng);

impl Stream {
    /// Creates a stream of a seed. Streams of other numbers are independent.
    pub fn new(seed: u64, number: impl Into<u64>) -> Self {
        let mut chacha = ChaCha8Rng::seed_from_u64(seed);
        chacha.set_stream(number.into());
        Self(chacha)
    }

    /// Creates the stream of a name, such as a sensor's. Streams of other names are independent.
    pub fn named(seed: u64, name: &str) -> Self {
        Self::new(seed, hash(name))
    }

    /// Returns a normal number with mean 0 and variance 1.
    pub fn normal(&mut self) -> f64 {
        self.0.sample(StandardNormal)
    }

    /// Returns N normal numbers with mean 0 and variance 1.
    pub fn normals<const N: usize>(&mut self) -> SVector<f64, N> {
        SVector::from_fn(|_, _| self.normal())
    }

    /// Returns a number that is uniform from `least` to below `most`.
    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.0.random::<f64>()
    }

    /// Returns a whole number from 0 to below `count`; 0 if that is 0.
    pub fn below(&mut self, count: u64) -> u64 {
        self.0.next_u64().checked_rem(count).unwrap_or(0)
    }

    /// Returns true with this probability, 0 to 1.
    pub fn happens(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }
}

/// Returns the FNV-1a hash of a text, 64 bits.
fn hash(text: &str) -> u64 {
    let mix = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3);
    text.bytes().fold(0xCBF2_9CE4_8422_2325, mix)
}
