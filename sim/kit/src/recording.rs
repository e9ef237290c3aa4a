//! A recording: named channels with units, and the samples of each by time.
//!
//! Channels have rates of their own. Times are in ns from the start of the run, so no format rounds them.

use std::fmt::Write as _;

use crate::error::Error;

/// Channels of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recording {
    pub(crate) channels: Vec<Recorded>,
}

/// Recorded samples of one channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded {
    name: String,
    unit: String,
    times: Vec<u64>,
    values: Vec<f64>,
}

impl Recorded {
    pub(crate) fn new(name: &str, unit: &str) -> Self {
        let (name, unit) = (name.to_owned(), unit.to_owned());
        Self { name, unit, times: Vec::new(), values: Vec::new() }
    }

    /// Returns the name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the unit; `1` for none.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// Returns the time of each sample, ns.
    pub fn times(&self) -> &[u64] {
        &self.times
    }

    /// Returns the value of each sample, in the channel's unit.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Returns the values from one time to another, s, both included.
    pub fn between(&self, from: f64, until: f64) -> &[f64] {
        let before = |limit: f64| move |time: &u64| (*time as f64 / 1e9) < limit;
        let start = self.times.partition_point(before(from));
        let end = self.times.partition_point(|time| *time as f64 / 1e9 <= until);
        &self.values[start..end.max(start)]
    }

    /// Returns the last value.
    pub fn last(&self) -> Option<f64> {
        self.values.last().copied()
    }
}

impl Recording {
    pub(crate) fn push(&mut self, channel: usize, time: u64, value: f64) {
        let channel = &mut self.channels[channel];
        channel.times.push(time);
        channel.values.push(value);
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
        self.channels.iter().find(|channel| channel.name == name).ok_or_else(|| {
            let known: Vec<&str> = self.channels.iter().map(Recorded::name).collect();
            Error::Unknown { name: name.to_owned(), known: known.join(", ") }
        })
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
            let _ = write!(text, "{}.{:09}", time / 1_000_000_000, time % 1_000_000_000);
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

/// Checks that a text can be a name or a unit in every format.
pub(crate) fn check_text(text: &str) -> Result<(), Error> {
    let is_bad = |it: char| it.is_control() || matches!(it, ',' | '"' | '\\' | '[' | ']');
    if text.is_empty() || text.chars().any(is_bad) {
        return Err(Error::Name { text: text.to_owned() });
    }
    Ok(())
}
