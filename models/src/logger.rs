//! The log of a flight (thesis, §6.1, data logger): a ring of records of fixed size.
//!
//! States, references, closed-loop and feed-forward commands unless others are chosen. When the ring is
//! full the oldest record makes room, and is counted. Knows signals by their numbers, not what they mean.

use bessemer::prelude::*;

/// How many signals there are to choose from.
#[data]
pub const SIGNALS: usize = 64;

/// How many signals a record holds.
#[data]
pub const WIDTH: usize = 36;

/// How many records the ring holds.
#[data]
pub const DEPTH: usize = 16;

/// One moment.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Record {
    /// When: periods since `init`.
    pub period: u32,
    /// The choice of signals that it holds.
    pub tag: u8,
    /// The chosen signals.
    pub values: [f64; WIDTH],
}

impl Default for Record {
    fn default() -> Self {
        Record { period: 0, tag: 0, values: [0.0; WIDTH] }
    }
}

/// What to write down, and how often.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// What the ground calls this choice: it comes down with each record.
    pub tag: u8,
    /// Every so many periods; 0 for never.
    pub every: u32,
    /// The numbers of the signals.
    pub signals: [u8; WIDTH],
}

impl Default for Choice {
    fn default() -> Self {
        Choice::usual()
    }
}

#[data]
impl Choice {
    /// The first signals, at 20 Hz.
    pub fn usual() -> Choice {
        let mut signals = [0; WIDTH];
        for n in 0..WIDTH {
            signals[n] = n as u8;
        }
        Choice { tag: 0, every: 10, signals }
    }
}

/// The data logger.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Logger {
    /// The ring.
    pub records: [Record; DEPTH],
    /// Where the oldest record is.
    pub first: usize,
    /// How many there are.
    pub count: usize,
    /// How many were overwritten before anyone took them.
    pub lost: u32,
    /// Periods since `init`.
    pub period: u32,
}

#[component]
impl Logger {
    /// One period: writes the chosen signals down if it is time to.
    #[entry(infallible)]
    pub fn step(&mut self, choice: &Choice, signals: &SVector<f64, SIGNALS>) {
        let due = choice.every != 0 && self.period % choice.every.max(1) == 0;
        if due {
            let mut record = Record { period: self.period, tag: choice.tag, values: [0.0; WIDTH] };
            for n in 0..WIDTH {
                let number = choice.signals[n] as usize;
                record.values[n] = signals[number % SIGNALS];
            }
            self.push(&record);
        }
        self.period = self.period.wrapping_add(1);
    }

    /// Puts a record behind the others.
    fn push(&mut self, record: &Record) {
        let first = self.first % DEPTH;
        let count = self.count.min(DEPTH);
        self.records[(first + count) % DEPTH] = *record;
        if count < DEPTH {
            self.count = count + 1;
        } else {
            self.first = (first + 1) % DEPTH;
            self.lost = self.lost.saturating_add(1);
        }
    }

    /// Whether there is a record to take.
    #[entry(infallible)]
    pub fn has_one(&self) -> bool {
        self.count > 0
    }

    /// Takes the oldest record; the last one taken again if there is none.
    #[entry(infallible)]
    pub fn take(&mut self) -> Record {
        let first = self.first % DEPTH;
        if self.count > 0 {
            self.first = (first + 1) % DEPTH;
            self.count = self.count.min(DEPTH) - 1;
        }
        self.records[first]
    }
}
