//! Sensors: the truth, and the ways in which a reading differs from it.
//!
//! A sensor knows the plant and not who uses its readings.

use std::fmt;

use crate::clock::{Period, Tick};
use crate::error::{Error, not_negative, probability};
use crate::noise::Chance;
use crate::plant::{Plant, View};
use crate::scenario::FaultKind;

/// Ideal sensor: a number of the plant.
///
/// A closure `Fn(&View<P, N>) -> f64` is a sensor.
pub trait Sensor<P: Plant<N>, const N: usize> {
    /// Returns the true value, in the sensor's unit.
    fn measure(&self, view: &View<'_, P, N>) -> f64;
}

impl<P: Plant<N>, const N: usize, F: Fn(&View<'_, P, N>) -> f64> Sensor<P, N> for F {
    fn measure(&self, view: &View<'_, P, N>) -> f64 {
        self(view)
    }
}

/// A number of the plant with a name and a unit. It is recorded as it is, or a [`Channel`] measures it.
pub struct Signal<P: Plant<N>, const N: usize> {
    /// Name in recordings.
    pub name: String,
    /// Unit in recordings; `1` for none.
    pub unit: String,
    /// The ideal sensor.
    pub sensor: Box<dyn Sensor<P, N>>,
}

impl<P: Plant<N>, const N: usize> Signal<P, N> {
    /// Creates a signal.
    pub fn new(name: &str, unit: &str, value: impl Fn(&View<'_, P, N>) -> f64 + 'static) -> Self {
        Self { name: name.to_owned(), unit: unit.to_owned(), sensor: Box::new(value) }
    }
}

impl<P: Plant<N>, const N: usize> fmt::Debug for Signal<P, N> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{} [{}]", self.name, self.unit)
    }
}

/// Quality of a real sensor. `Default` is an ideal one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quality {
    /// Standard deviation of white noise, in the sensor's unit.
    pub noise: f64,
    /// Bias at the start, in the sensor's unit; of either sign.
    pub bias: f64,
    /// Standard deviation of the bias after 1 s of random walk, in the sensor's unit per √s.
    pub walk: f64,
    /// Resolution: readings are multiples of it. In the sensor's unit; 0 for none.
    pub resolution: f64,
    /// Probability that a reading is lost, 0 to 1.
    pub dropout: f64,
}

impl Quality {
    fn check(&self, name: &str) -> Result<(), Error> {
        let item = |field: &str| format!("{field} of {name}");
        not_negative(&item("noise"), self.noise)?;
        not_negative(&item("bias"), self.bias.abs())?;
        not_negative(&item("walk"), self.walk)?;
        not_negative(&item("resolution"), self.resolution)?;
        probability(&item("dropout"), self.dropout).map(drop)
    }
}

/// A real sensor: a signal, sampled with a period and a quality.
#[derive(Debug)]
pub struct Channel<P: Plant<N>, const N: usize> {
    /// The signal.
    pub signal: Signal<P, N>,
    /// Period of the samples.
    pub period: Period,
    /// Quality of the readings.
    pub quality: Quality,
}

/// Latest reading of a sensor, as the computer gets it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// The latest value, in the sensor's unit; 0 until there is one.
    pub value: f64,
    /// True if the value arrived after the computer's last step.
    pub is_fresh: bool,
}

/// Memory of a real sensor within a run.
pub(crate) struct Sampler {
    chance: Chance,
    /// Number of the next sample.
    sample: u64,
    bias: f64,
    /// Standard deviation of a step of the bias, in the sensor's unit.
    wander: f64,
    stuck: Option<f64>,
}

impl Sampler {
    pub(crate) fn new<P: Plant<N>, const N: usize>(
        channel: &Channel<P, N>,
        seed: u64,
        tick: Tick,
    ) -> Result<Self, Error> {
        channel.quality.check(&channel.signal.name)?;
        Ok(Self {
            chance: Chance::new(seed, &channel.signal.name),
            sample: 0,
            bias: channel.quality.bias,
            wander: channel.quality.walk * channel.period.seconds(tick).sqrt(),
            stuck: None,
        })
    }

    /// Returns the reading of a true value; `None` if it is lost. `last` is the latest reading.
    pub(crate) fn read(
        &mut self,
        quality: &Quality,
        truth: f64,
        fault: Option<FaultKind>,
        last: f64,
    ) -> Option<f64> {
        let ([white, walk], lost) = self.chance.normal(self.sample);
        self.sample += 1;
        let value = truth + self.bias + quality.noise * white;
        self.bias += self.wander * walk;
        let value = match fault {
            Some(FaultKind::Offset(offset)) => value + offset,
            _ => value,
        };
        let value = if quality.resolution > 0.0 {
            // Without the sum, a small negative value would be −0.
            (value / quality.resolution).round() * quality.resolution + 0.0
        } else {
            value
        };
        self.stuck = match fault {
            Some(FaultKind::Stuck) => Some(self.stuck.unwrap_or(last)),
            _ => None,
        };
        if lost < quality.dropout || fault == Some(FaultKind::Silent) {
            return None;
        }
        Some(self.stuck.unwrap_or(value))
    }
}
