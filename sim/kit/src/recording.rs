//! A recording: named channels with units, and the samples of each by time.
//!
//! Channels have rates of their own. Times are in ns from the start of the run, so no format rounds them. In s they count from time 0,
//! which is the start, or later by a lead.

use std::fmt::Write as _;

use crate::error::{Error, checked, not_negative};

/// Channels of a run, or of a loop of your own.
///
/// ```
/// # use bessemer_sim::Recording;
/// let mut recording = Recording::new(0.5)?;
/// let speed = recording.add("speed", "m/s")?;
/// recording.sample(speed, 0, 1.5)?;
/// recording.sample(speed, 500_000_000, 2.5)?;
/// assert_eq!(recording.csv(), "time [s],speed [m/s]\n-0.500000000,1.5\n0.000000000,2.5\n");
/// # Ok::<(), bessemer_sim::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recording {
    channels: Vec<Recorded>,
    /// Time from the start to time 0, ns.
    lead: u64,
}

/// Recorded samples of one channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded {
    name: String,
    unit: String,
    /// Time from the start to time 0, ns.
    lead: u64,
    times: Vec<u64>,
    values: Vec<f64>,
}

impl Recorded {
    /// Returns the name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the unit; `1` for none.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// Returns the time of each sample, ns from the start.
    pub fn times(&self) -> &[u64] {
        &self.times
    }

    /// Returns the value of each sample, in the channel's unit.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Returns a time in ns from the start as a time in s.
    pub(crate) fn seconds(&self, time: u64) -> f64 {
        after(time, self.lead) as f64 / 1e9
    }

    /// Returns the values from one time to another, s, both included.
    pub fn between(&self, from: f64, until: f64) -> &[f64] {
        let start = self.times.partition_point(|time| self.seconds(*time) < from);
        let end = self.times.partition_point(|time| self.seconds(*time) <= until);
        &self.values[start..end.max(start)]
    }

    /// Returns the last value.
    pub fn last(&self) -> Option<f64> {
        self.values.last().copied()
    }
}

impl Recording {
    /// Creates an empty recording that starts `lead` s before time 0, at which a flight takes off or a test begins; 0 for none.
    ///
    /// # Errors
    ///
    /// The lead is negative, not finite, or longer than 10⁹ s.
    pub fn new(lead: f64) -> Result<Self, Error> {
        let lead = checked("lead", not_negative("lead", lead)?, "at most 10⁹ s", lead <= 1e9)?;
        Ok(Self { channels: Vec::new(), lead: (lead * 1e9).round() as u64 })
    }

    /// Adds a channel with its unit, `1` for none; returns its index.
    ///
    /// # Errors
    ///
    /// Another channel has the name, or name or unit has a character that some format cannot write.
    pub fn add(&mut self, name: &str, unit: &str) -> Result<usize, Error> {
        check_text(name)?;
        check_text(unit)?;
        let (name, unit, lead) = (name.to_owned(), unit.to_owned(), self.lead);
        if self.channels.iter().any(|channel| channel.name == name) {
            return Err(Error::Twice { name });
        }
        self.channels.push(Recorded { name, unit, lead, times: Vec::new(), values: Vec::new() });
        Ok(self.channels.len() - 1)
    }

    /// Records a sample of a channel, by its index, at a time in ns from the start.
    ///
    /// # Errors
    ///
    /// There is no such channel, or its last sample is not before this one.
    pub fn sample(&mut self, channel: usize, time: u64, value: f64) -> Result<(), Error> {
        let Some(it) = self.channels.get(channel) else {
            return Err(self.unknown(&channel.to_string()));
        };
        if it.times.last().is_some_and(|last| *last >= time) {
            return Err(Error::Late { name: it.name.clone(), time: it.seconds(time) });
        }
        self.push(channel, time, value);
        Ok(())
    }

    pub(crate) fn push(&mut self, channel: usize, time: u64, value: f64) {
        let channel = &mut self.channels[channel];
        channel.times.push(time);
        channel.values.push(value);
    }

    fn unknown(&self, name: &str) -> Error {
        let known: Vec<&str> = self.channels.iter().map(Recorded::name).collect();
        Error::Unknown { name: name.to_owned(), known: known.join(", ") }
    }

    /// Returns the channels, in the order of the setup: sensors, then probes.
    pub fn channels(&self) -> &[Recorded] {
        &self.channels
    }

    /// Returns the channel of a name.
    ///
    /// # Errors
    ///
    /// No channel has the name.
    pub fn channel(&self, name: &str) -> Result<&Recorded, Error> {
        self.channels.iter().find(|it| it.name == name).ok_or_else(|| self.unknown(name))
    }

    /// Formats the recording as comma-separated values: a header `time [s],name [unit],…`, and a line for each time.
    ///
    /// A cell is empty if its channel has no sample at that time. Reading a number back gives its bits.
    pub fn csv(&self) -> String {
        let mut text = String::from("time [s]");
        for channel in &self.channels {
            let _ = write!(text, ",{} [{}]", channel.name, channel.unit);
        }
        text.push('\n');
        for (time, samples) in self.rows() {
            let time = after(time, self.lead);
            let (sign, size) = (if time < 0 { "-" } else { "" }, time.unsigned_abs());
            let _ = write!(text, "{sign}{}.{:09}", size / 1_000_000_000, size % 1_000_000_000);
            for sample in samples {
                text.push(',');
                if let Some(value) = sample {
                    let _ = write!(text, "{value}");
                }
            }
            text.push('\n');
        }
        text
    }

    /// Iterates the times in order, ns, each with the sample of each channel.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (u64, Vec<Option<f64>>)> + '_ {
        let mut next = vec![0; self.channels.len()];
        std::iter::from_fn(move || {
            let heads = self.channels.iter().zip(&next);
            let time =
                heads.filter_map(|(channel, next)| channel.times.get(*next)).min().copied()?;
            let sample = |(channel, next): (&Recorded, &mut usize)| {
                let is_now = channel.times.get(*next) == Some(&time);
                let value = is_now.then(|| channel.values[*next]);
                *next += usize::from(is_now);
                value
            };
            Some((time, self.channels.iter().zip(&mut next).map(sample).collect()))
        })
    }
}

/// Returns the time behind a lead, ns; both are below 2⁶³.
fn after(time: u64, lead: u64) -> i64 {
    (time as i64).saturating_sub(lead as i64)
}

/// Checks that a text can be a name or a unit in every format.
fn check_text(text: &str) -> Result<(), Error> {
    let is_bad = |it: char| it.is_control() || matches!(it, ',' | '"' | '\\' | '[' | ']');
    if text.is_empty() || text.chars().any(is_bad) {
        return Err(Error::Name { text: text.to_owned() });
    }
    Ok(())
}
