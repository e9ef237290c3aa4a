//! Resamples the topics of a flight log to the period of an entry point.
//!
//! The rule: the first call is at the first time at which each topic has had a sample, and a call follows each period up to the
//! time of the last sample of any of them. A call takes the latest sample of each topic that is not later than the call: nothing is
//! interpolated, and no number of the log changes its bits. Times are whole nanoseconds.
//!
//! Must not know: parameters, and formats of logs.

use super::super::Row;
use super::bytes::Number;
use super::error::Wrong;
use super::log::{Log, Topic};

/// Most calls, and most for each sample: more come of a time that jumps, or of a wrong period.
const MOST: i128 = 10_000_000;
const MOST_FOR_A_SAMPLE: i128 = 10_000;

/// Nanoseconds in a microsecond.
const MICRO: i128 = 1000;

/// Origin of a number that goes in.
#[derive(Clone)]
pub(super) enum Origin {
    /// A number that holds in each call.
    Number(String),
    /// A field of a topic, times a factor.
    Sampled { topic: usize, field: usize, factor: Option<f64> },
}

/// The calls, with a cell for each origin.
pub(super) fn rows(log: &Log, origins: &[Origin], period: u64) -> Result<Vec<Row>, Wrong> {
    let mut used: Vec<Track<'_>> = Vec::new();
    for origin in origins {
        if let Origin::Sampled { topic, .. } = origin
            && !used.iter().any(|it| it.at == *topic)
            && let Some(of) = log.topics.get(*topic)
        {
            used.push(Track::new(*topic, of)?);
        }
    }
    let (period, start) = (i128::from(period.max(1)), used.iter().filter_map(Track::first).max());
    let end = used.iter().filter_map(Track::last).max();
    let (Some(start), Some(end)) = (start, end) else { return Ok(Vec::new()) };
    let calls = (end - start).max(0) * MICRO / period + 1;
    let samples: usize = used.iter().map(|it| it.times.len()).sum();
    let most = MOST.min(MOST_FOR_A_SAMPLE * samples as i128);
    if calls > most {
        return Err(Wrong::Long { from: start, to: end, calls, most });
    }
    let mut rows = Vec::new();
    for call in 0..calls {
        let time = start * MICRO + call * period;
        used.iter_mut().for_each(|it| it.advance(time));
        let cells = origins.iter().map(|origin| match origin {
            Origin::Number(text) => text.clone(),
            Origin::Sampled { topic, field, factor } => {
                let track = used.iter().find(|it| it.at == *topic);
                let number = track.and_then(|it| it.number(*field));
                number.map_or(String::new(), |it| Origin::text(it, *factor))
            }
        });
        let place = format!("call {} at {}.{:03} µs", call + 1, time / MICRO, time % MICRO);
        rows.push(Row { place, cells: cells.collect() });
    }
    Ok(rows)
}

/// A topic with the sample that holds.
struct Track<'l> {
    /// Place of the topic in the log.
    at: usize,
    topic: &'l Topic,
    /// Times of the samples, µs; they do not go back.
    times: Vec<i128>,
    /// Place of the sample that holds.
    now: usize,
}

impl<'l> Track<'l> {
    fn new(at: usize, topic: &'l Topic) -> Result<Track<'l>, Wrong> {
        let mut times: Vec<i128> = Vec::with_capacity(topic.samples.len());
        for sample in &topic.samples {
            let number = topic.time.and_then(|it| sample.numbers.get(it));
            let time = number.map_or(0, |it| match *it {
                Number::Int(time) => i128::from(time),
                Number::Whole(time) => i128::from(time),
                Number::Float(time) => time as i128,
            });
            if let Some(before) = times.last().copied().filter(|before| *before > time) {
                let (topic, sample) = (topic.name.clone(), times.len() + 1);
                return Err(Wrong::Back { topic, sample, time, before });
            }
            times.push(time);
        }
        Ok(Track { at, topic, times, now: 0 })
    }

    fn first(&self) -> Option<i128> {
        self.times.first().copied()
    }

    fn last(&self) -> Option<i128> {
        self.times.last().copied()
    }

    /// Goes on to the latest sample that is not later than a time in nanoseconds.
    fn advance(&mut self, time: i128) {
        while self.times.get(self.now + 1).is_some_and(|next| next * MICRO <= time) {
            self.now += 1;
        }
    }

    fn number(&self, field: usize) -> Option<Number> {
        self.topic.samples.get(self.now)?.numbers.get(field).copied()
    }
}
