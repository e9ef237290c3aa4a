//! A run before it is run: its duration, its goals, its disturbances and its faults by time.
//!
//! Plain data; the seed is part of it, so a run depends on nothing else.

use crate::error::{Error, not_negative, positive};

/// Value that changes at known times.
///
/// Invariant: times are finite, above 0 and rising.
#[derive(Clone, Debug, PartialEq)]
pub struct Timeline<T> {
    first: T,
    changes: Vec<(f64, T)>,
}

impl<T> Timeline<T> {
    /// Creates a value that never changes.
    pub fn constant(value: T) -> Self {
        Self { first: value, changes: Vec::new() }
    }

    /// Creates a value that is `first` from time 0 on, and then changes at each time, s.
    ///
    /// # Errors
    ///
    /// A time is not finite, not above 0, or not after the time before it.
    pub fn new(first: T, changes: Vec<(f64, T)>) -> Result<Self, Error> {
        let mut before = 0.0;
        for (time, _) in &changes {
            positive("time of a change", *time)?;
            if *time <= before {
                return Err(Error::Unsorted { time: *time });
            }
            before = *time;
        }
        Ok(Self { first, changes })
    }

    /// Returns the value at a time, s, which includes a change at that time.
    pub fn at(&self, time: f64) -> &T {
        let past = self.changes.partition_point(|(change, _)| *change <= time);
        past.checked_sub(1).map_or(&self.first, |index| &self.changes[index].1)
    }

    /// Returns the times of the changes, s.
    pub fn times(&self) -> impl Iterator<Item = f64> + '_ {
        self.changes.iter().map(|(time, _)| *time)
    }
}

/// Kind of a sensor's fault.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FaultKind {
    /// The sensor repeats its last reading, as if it were new.
    Stuck,
    /// The sensor has no readings.
    Silent,
    /// The readings have an offset, in the sensor's unit.
    Offset(f64),
    /// The readings have an offset that grows from 0 at the begin of the fault, in the sensor's unit per second.
    Drift(f64),
}

/// Fault of a sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Name of the sensor.
    pub sensor: String,
    /// Time at which it begins, s.
    pub from: f64,
    /// Time at which it ends, s; infinity for never.
    pub until: f64,
    /// Kind of the fault. If two overlap, the first in the list has effect.
    pub kind: FaultKind,
}

impl Fault {
    pub(crate) fn check(&self) -> Result<(), Error> {
        not_negative("from", self.from)?;
        match self.kind {
            FaultKind::Offset(offset) => not_negative("offset", offset.abs())?,
            FaultKind::Drift(rate) => not_negative("drift", rate.abs())?,
            FaultKind::Stuck | FaultKind::Silent => 0.0,
        };
        if self.until > self.from {
            Ok(())
        } else {
            Err(Error::Backwards { from: self.from, until: self.until })
        }
    }
}

/// Everything that happens to a loop of goals G and disturbances D.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario<G, D> {
    /// Duration, s.
    pub duration: f64,
    /// Goals of the computer, such as a speed to hold.
    pub goals: Timeline<G>,
    /// Disturbances of the plant, such as steps of a load.
    pub disturbances: Timeline<D>,
    /// Faults of sensors.
    pub faults: Vec<Fault>,
    /// Seed of all chance.
    pub seed: u64,
}

impl<G, D> Scenario<G, D> {
    /// Returns the fault of a sensor at a time, s; a drift as its offset at that time.
    pub(crate) fn fault(&self, sensor: &str, time: f64) -> Option<FaultKind> {
        let is_at =
            |fault: &&Fault| fault.sensor == sensor && fault.from <= time && time < fault.until;
        self.faults.iter().find(is_at).map(|fault| match fault.kind {
            FaultKind::Drift(rate) => FaultKind::Offset(rate * (time - fault.from)),
            kind => kind,
        })
    }
}
