//! A run before it is run: its duration, its goals, its disturbances, its faults and whatever else happens, by time.
//!
//! Plain data; the seed is part of it, so a run depends on nothing else.

use std::cmp::Ordering;
use std::{slice, vec};

use crate::error::{Error, not_negative, positive};

/// Events of a type of yours by time in s, such as orders of an operator and failures, for a loop of your own.
///
/// Invariant: times do not fall, and simultaneous events are in the order in which they were added. An event at NaN or
/// infinity never happens.
///
/// ```
/// use bessemer_sim::Events;
///
/// let mut events: Events<&str> = [(2.0, "land"), (-1.0, "arm"), (0.0, "take off")].into_iter().collect();
/// events.add(0.0, "start the clock");
/// let mut pending = events.pending();
/// assert_eq!(pending.due(-0.5), [(-1.0, "arm")]);
/// assert_eq!(pending.due(1.0), [(0.0, "take off"), (0.0, "start the clock")]);
/// assert_eq!(pending.due(1.0), []);
/// assert_eq!(events.past(2.0).last(), Some(&(2.0, "land")));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Events<E>(Vec<(f64, E)>);

impl<E> Events<E> {
    /// Adds an event at a time, s, behind those of the same time.
    pub fn add(&mut self, time: f64, event: E) {
        let place = self.0.partition_point(|(other, _)| order(*other, time).is_le());
        self.0.insert(place, (time, event));
    }

    /// Returns the events up to a time, s, which includes those at that time.
    pub fn past(&self, time: f64) -> &[(f64, E)] {
        &self.0[..self.0.partition_point(|(event, _)| *event <= time)]
    }

    /// Returns the events as a queue, from which a loop takes those that are due.
    pub fn pending(&self) -> Pending<'_, E> {
        Pending(&self.0)
    }

    /// Iterates over the events in order, each with its time, s.
    pub fn iter(&self) -> slice::Iter<'_, (f64, E)> {
        self.0.iter()
    }
}

/// Returns the order of two times; NaN is behind all others.
fn order(one: f64, other: f64) -> Ordering {
    let numbers = one.partial_cmp(&other);
    numbers.unwrap_or_else(|| one.is_nan().cmp(&other.is_nan()))
}

impl<E> Default for Events<E> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<E> Extend<(f64, E)> for Events<E> {
    fn extend<I: IntoIterator<Item = (f64, E)>>(&mut self, events: I) {
        self.0.extend(events);
        self.0.sort_by(|(one, _), (other, _)| order(*one, *other));
    }
}

impl<E> FromIterator<(f64, E)> for Events<E> {
    fn from_iter<I: IntoIterator<Item = (f64, E)>>(events: I) -> Self {
        let mut all = Self::default();
        all.extend(events);
        all
    }
}

impl<E> IntoIterator for Events<E> {
    type Item = (f64, E);
    type IntoIter = vec::IntoIter<(f64, E)>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a, E> IntoIterator for &'a Events<E> {
    type Item = &'a (f64, E);
    type IntoIter = slice::Iter<'a, (f64, E)>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// Events that have not happened yet.
#[derive(Clone, Debug)]
pub struct Pending<'a, E>(&'a [(f64, E)]);

impl<'a, E> Pending<'a, E> {
    /// Takes the events up to a time, s, which includes those at that time. Each is returned once, with its own time.
    pub fn due(&mut self, time: f64) -> &'a [(f64, E)] {
        let count = self.0.iter().take_while(|(event, _)| *event <= time).count();
        let (due, rest) = self.0.split_at(count);
        self.0 = rest;
        due
    }
}

/// Value that changes at known times.
///
/// Invariant: times are finite, above 0 and rising.
#[derive(Clone, Debug, PartialEq)]
pub struct Timeline<T> {
    first: T,
    changes: Events<T>,
}

impl<T> Timeline<T> {
    /// Creates a value that never changes.
    pub fn constant(value: T) -> Self {
        Self { first: value, changes: Events::default() }
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
        Ok(Self { first, changes: Events(changes) })
    }

    /// Returns the value at a time, s, which includes a change at that time.
    pub fn at(&self, time: f64) -> &T {
        self.changes.past(time).last().map_or(&self.first, |(_, value)| value)
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
    /// Returns the fault of a sensor at a time, s; a drift as its offset at that time.
    pub fn at(faults: &[Fault], sensor: &str, time: f64) -> Option<FaultKind> {
        let is_at =
            |fault: &&Fault| fault.from <= time && time < fault.until && fault.sensor == sensor;
        faults.iter().find(is_at).map(|fault| match fault.kind {
            FaultKind::Drift(rate) => FaultKind::Offset(rate * (time - fault.from)),
            kind => kind,
        })
    }

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
