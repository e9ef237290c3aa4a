//! Messages that are sent again and again, each with its own period, and those that are sent on request.
//!
//! Invariants:
//! - a message whose values come from the downlink is sent once for a record, however short its period is;
//! - the heartbeat is never switched off.
//!
//! It must not know what the messages contain.

use std::time::Duration;

/// Longest period of a message, s.
const LONGEST: f64 = 3600.0;

/// When a message is sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// With a record of the downlink.
    Record,
    /// With the state of the aircraft, while its telemetry arrives.
    State,
    /// Only on request.
    Request,
}

/// A message with its period.
#[derive(Clone, Copy, Debug)]
struct Stream {
    id: u32,
    source: Source,
    /// Initial period, control periods; none if it is sent on request alone.
    initial: Option<u64>,
    /// Present period, control periods.
    every: Option<u64>,
    /// Control period in which it is due.
    due: u64,
    /// Record that was sent last.
    sent: Option<u32>,
}

/// The messages with their periods.
#[derive(Clone, Debug)]
pub struct Streams {
    streams: Vec<Stream>,
    /// The control period, s.
    period: f64,
}

/// Reason why a period is not changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unchanged {
    /// There is no such message.
    Unknown,
    /// The message cannot have this period.
    Denied,
}

impl Streams {
    /// Creates streams from numbers of messages, with their sources and periods in control periods of a length, s.
    pub fn new(rows: &[(u32, Source, Option<u64>)], period: Duration) -> Self {
        let stream = |&(id, source, initial): &(u32, Source, Option<u64>)| Stream {
            id,
            source,
            initial,
            every: initial,
            due: 0,
            sent: None,
        };
        Self { streams: rows.iter().map(stream).collect(), period: period.as_secs_f64() }
    }

    /// Returns true if there is a message with a number.
    pub fn contains(&self, id: u32) -> bool {
        self.streams.iter().any(|it| it.id == id)
    }

    /// Changes the period of a message, µs: 0 restores the initial one, -1 switches it off.
    ///
    /// # Errors
    ///
    /// There is no such message, it is not sent periodically, or the number is no period.
    pub fn set(&mut self, id: u32, interval: f64, kept: u32) -> Result<(), Unchanged> {
        let period = self.period;
        let stream = self.streams.iter_mut().find(|it| it.id == id).ok_or(Unchanged::Unknown)?;
        let seconds = interval * 1e-6;
        stream.every = match interval {
            0.0 => stream.initial,
            -1.0 if id != kept => None,
            _ if seconds > 0.0 && seconds <= LONGEST && stream.source != Source::Request => {
                Some(((seconds / period).round() as u64).max(1))
            }
            _ => return Err(Unchanged::Denied),
        };
        stream.due = 0;
        Ok(())
    }

    /// Returns the period of a message, µs: 0 if there is none such, -1 if it is not sent.
    pub fn interval(&self, id: u32) -> i32 {
        match self.streams.iter().find(|it| it.id == id).map(|it| it.every) {
            None => 0,
            Some(None) => -1,
            Some(Some(every)) => (every as f64 * self.period * 1e6).round() as i32,
        }
    }

    /// Returns the numbers of the messages that are due in a control period, and plans the next.
    ///
    /// `record` is the number of the last record; `alive` is true while telemetry arrives.
    pub fn due(&mut self, now: u64, record: Option<u32>, alive: bool) -> Vec<u32> {
        let mut due = Vec::new();
        for stream in &mut self.streams {
            let Some(every) = stream.every.filter(|_| now >= stream.due) else { continue };
            let ready = match stream.source {
                Source::Record => record.is_some() && record != stream.sent,
                Source::State | Source::Request => alive,
            };
            if ready {
                // The periods of a message begin at multiples, so that a late one is not followed by more late ones.
                (stream.due, stream.sent) = ((now / every + 1) * every, record);
                due.push(stream.id);
            }
        }
        due
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEART: u32 = 0;

    fn streams() -> Streams {
        let rows = [
            (HEART, Source::State, Some(200)),
            (30, Source::Record, Some(4)),
            (148, Source::Request, None),
        ];
        Streams::new(&rows, Duration::from_millis(5))
    }

    /// Returns how often messages are sent in control periods, with a record in every `records`-th.
    fn counts(streams: &mut Streams, periods: u64, records: u64) -> [usize; 3] {
        let sent: Vec<u32> = (1..=periods)
            .flat_map(|now| streams.due(now, Some((now / records) as u32), true))
            .collect();
        [HEART, 30, 148].map(|id| sent.iter().filter(|it| **it == id).count())
    }

    #[test]
    fn a_message_has_its_period_and_a_record_is_sent_once() {
        assert_eq!(counts(&mut streams(), 2000, 4), [11, 501, 0]);
        // Records are rarer than the period.
        assert_eq!(counts(&mut streams(), 2000, 20), [11, 101, 0]);
        assert_eq!(streams().due(1, None, false), [0; 0], "no telemetry");
    }

    #[test]
    fn a_period_changes_and_returns() {
        let mut it = streams();
        assert_eq!(it.set(30, 100_000.0, HEART), Ok(()));
        assert_eq!((it.interval(30), counts(&mut it, 2000, 4)[1]), (100_000, 101));
        assert_eq!(it.set(30, -1.0, HEART), Ok(()));
        assert_eq!((it.interval(30), counts(&mut it, 2000, 4)[1]), (-1, 0));
        assert_eq!(it.set(30, 0.0, HEART), Ok(()));
        assert_eq!((it.interval(30), it.interval(148), it.interval(7)), (20_000, -1, 0));
    }

    #[test]
    fn what_is_no_period_changes_nothing() {
        let mut it = streams();
        assert_eq!(it.set(7, 1000.0, HEART), Err(Unchanged::Unknown));
        for (id, interval) in [(HEART, -1.0), (30, -2.0), (30, f64::NAN), (30, 1e12), (148, 1000.0)]
        {
            assert_eq!(it.set(id, interval, HEART), Err(Unchanged::Denied), "{id} {interval}");
        }
        assert_eq!((it.interval(HEART), it.interval(30)), (1_000_000, 20_000));
    }
}
