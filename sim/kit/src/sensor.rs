//! Sensors: the truth, and the ways in which a reading differs from it.
//!
//! A sensor knows the plant and not who uses its readings.

use std::collections::VecDeque;
use std::fmt;

use crate::clock::{Period, Tick};
use crate::error::{Error, checked, not_negative, probability};
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
    /// Probability that a reading is an outlier, 0 to 1.
    pub outliers: f64,
    /// Largest error of an outlier, in the sensor's unit. The errors are uniform from minus this to this.
    pub outlier_size: f64,
    /// Resolution: readings are multiples of it. In the sensor's unit; 0 for none.
    pub resolution: f64,
    /// Least and largest reading, at which the sensor saturates, in its unit.
    pub limits: Option<(f64, f64)>,
    /// Probability that a reading is lost, 0 to 1.
    pub dropout: f64,
    /// Delay between the sample and its arrival, in ticks.
    pub delay: u32,
}

impl Quality {
    fn check(&self, name: &str) -> Result<(), Error> {
        let item = |field: &str| format!("{field} of {name}");
        not_negative(&item("noise"), self.noise)?;
        not_negative(&item("bias"), self.bias.abs())?;
        not_negative(&item("walk"), self.walk)?;
        not_negative(&item("resolution"), self.resolution)?;
        probability(&item("outliers"), self.outliers)?;
        not_negative(&item("outlier_size"), self.outlier_size)?;
        let (least, most) = self.limits.unwrap_or_default();
        checked(&item("limits"), most, "at least the lower limit", least <= most)?;
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

/// Latest reading of a sensor, as the computer gets it: a number, or the numbers of a packet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading<T = f64> {
    /// The latest value, in the sensor's unit; 0 until there is one.
    pub value: T,
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
    /// Latest sample that was not lost, in the sensor's unit.
    last: f64,
    stuck: Option<f64>,
    /// Samples that have not arrived, each with the tick of its arrival, in order.
    underway: VecDeque<(u64, f64)>,
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
            last: 0.0,
            stuck: None,
            underway: VecDeque::new(),
        })
    }

    /// Samples a true value at a tick.
    pub(crate) fn sample(
        &mut self,
        quality: &Quality,
        now: u64,
        truth: f64,
        fault: Option<FaultKind>,
    ) {
        if let Some(value) = self.value(quality, truth, fault) {
            self.last = value;
            self.underway.push_back((now.saturating_add(quality.delay.into()), value));
        }
    }

    /// Returns the next reading that has arrived by a tick, and the tick of its arrival.
    pub(crate) fn arrived(&mut self, now: u64) -> Option<(u64, f64)> {
        self.underway.pop_front_if(|(tick, _)| *tick <= now)
    }

    /// Returns the sensor's value of a true value; `None` if it is lost.
    fn value(&mut self, quality: &Quality, truth: f64, fault: Option<FaultKind>) -> Option<f64> {
        let draws = self.chance.draws(self.sample);
        self.sample += 1;
        let mut value = truth + self.bias + quality.noise * draws.white;
        self.bias += self.wander * draws.walk;
        if let Some(FaultKind::Offset(offset)) = fault {
            value += offset;
        }
        if draws.outlier < quality.outliers {
            value += quality.outlier_size * draws.size;
        }
        if quality.resolution > 0.0 {
            // Without the sum, a small negative value would be −0.
            value = (value / quality.resolution).round() * quality.resolution + 0.0;
        }
        if let Some((least, most)) = quality.limits {
            // The limits are checked. NaN stays.
            value = value.clamp(least, most);
        }
        self.stuck = match fault {
            Some(FaultKind::Stuck) => Some(self.stuck.unwrap_or(self.last)),
            _ => None,
        };
        if draws.lost < quality.dropout || fault == Some(FaultKind::Silent) {
            return None;
        }
        Some(self.stuck.unwrap_or(value))
    }
}
