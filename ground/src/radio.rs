//! A simulated link with the errors of real ones: it loses datagrams, duplicates, delays and reorders them.
//!
//! Knows bytes and times, but no socket. Its errors come from a seed, so that a flight over a bad link can be
//! repeated.

use serde::Serialize;
use sim::noise::{Purpose, Stream};
use std::collections::VecDeque;

/// Delay of a datagram that is overtaken, s.
const OVERTAKEN_DELAY: f64 = 0.03;

/// Quality of a link: probabilities for each datagram, and a delay for all.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quality {
    /// Probability that a datagram is lost.
    pub loss: f64,
    /// Probability that a datagram is delivered twice.
    pub duplication: f64,
    /// Probability that a datagram is overtaken by later ones.
    pub reordering: f64,
    /// Delay, s.
    pub delay: f64,
}

/// Counters of the datagrams by their fate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Number of datagrams sent.
    pub sent: u64,
    /// Number of datagrams lost.
    pub lost: u64,
    /// Number of datagrams delivered twice.
    pub doubled: u64,
    /// Number of datagrams delayed so that others overtook them.
    pub overtaken: u64,
}

/// One direction of a link.
#[derive(Clone, Debug)]
pub struct Way {
    /// Quality of the link.
    pub quality: Quality,
    /// Counters of the datagrams.
    pub counts: Counts,
    waiting: VecDeque<(f64, Vec<u8>)>,
    stream: Stream,
}

impl Way {
    /// Creates one direction of a link with a seed.
    pub fn new(quality: Quality, seed: u64) -> Self {
        let stream = Stream::new(seed, Purpose::Radio);
        Self { quality, counts: Counts::default(), waiting: VecDeque::new(), stream }
    }

    /// Sends a datagram at a time, s.
    pub fn send(&mut self, now: f64, bytes: &[u8]) {
        let Quality { loss, duplication, reordering, delay } = self.quality;
        self.counts.sent += 1;
        // Three throws for each datagram, so that one probability moves nothing of another.
        let (lost, doubled, overtaken) = (
            self.stream.happens(loss),
            self.stream.happens(duplication),
            self.stream.happens(reordering),
        );
        if lost {
            self.counts.lost += 1;
            return;
        }
        let due = now + delay + if overtaken { OVERTAKEN_DELAY } else { 0.0 };
        self.counts.overtaken += u64::from(overtaken);
        self.insert(due, bytes);
        if doubled {
            self.counts.doubled += 1;
            self.insert(due, bytes);
        }
    }

    /// The datagrams that have arrived by a time, s.
    pub fn arrived(&mut self, now: f64) -> Vec<Vec<u8>> {
        let count = self.waiting.partition_point(|(due, _)| *due <= now);
        self.waiting.drain(..count).map(|(_, bytes)| bytes).collect()
    }

    /// Inserts a datagram after all that are due earlier or at the same time.
    fn insert(&mut self, due: f64, bytes: &[u8]) {
        let place = self.waiting.partition_point(|(other, _)| *other <= due);
        self.waiting.insert(place, (due, bytes.to_vec()));
    }
}
