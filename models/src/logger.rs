//! Flight log (thesis, §6.1, data logger): a ring of records of fixed size.
//!
//! The default selection is states, references, closed-loop and feed-forward commands. A full ring overwrites the
//! oldest record and counts it as lost. Signals are known by number only.

use bessemer::prelude::*;

/// Number of signals to choose from.
#[data]
pub const SIGNALS: usize = 64;

/// Number of signals in a record.
#[data]
pub const WIDTH: usize = 36;

/// Number of records in the ring.
#[data]
pub const DEPTH: usize = 16;

/// The signals at one time.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Record {
    /// Time, in periods since initialisation.
    pub period: u32,
    /// Tag of the selection of signals.
    pub tag: u8,
    /// The chosen signals.
    pub values: [f64; WIDTH],
}

impl Default for Record {
    fn default() -> Self {
        Record { period: 0, tag: 0, values: [0.0; WIDTH] }
    }
}

/// Selection of signals and the period of recording.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// Tag of the selection, which the ground station chooses and each record repeats.
    pub tag: u8,
    /// Period of recording, in control periods; 0 to record nothing.
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
    /// Returns the first signals at 20 Hz.
    #[requirement("HLR-40")]
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
    /// Index of the oldest record.
    pub first: usize,
    /// Number of records.
    pub count: usize,
    /// Number of records overwritten before they were sent.
    pub lost: u32,
    /// Periods since initialisation.
    pub period: u32,
}

#[component]
impl Logger {
    /// Advances one period and records the selected signals if a record is due.
    #[requirement("HLR-40")]
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

    /// Appends a record and overwrites the oldest one if the ring is full.
    #[requirement("HLR-40")]
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

    /// Returns true if there is a record to take.
    #[entry(infallible)]
    pub fn has_one(&self) -> bool {
        self.count > 0
    }

    /// Removes and returns the oldest record; returns an old one if there is none.
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
