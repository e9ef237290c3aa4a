//! Campaigns of very many flights: random scenarios from seeds, the result of each flight, and a summary.
//!
//! | module | what it says |
//! |---|---|
//! | [`dice`] | the scenario of a seed: parameters, trajectory, air, sensors, outages, failures |
//! | [`outcome`] | how one flight went, as a line of text |
//! | [`ledger`] | the lines of a campaign in a file: what is there need not be flown again |
//! | [`tally`] | percentiles and verdicts over all lines |
//!
//! A flight depends on its seed and on nothing else, so a campaign can be cut by seeds, stopped and gone
//! on with, and run on any number of machines.

pub mod dice;
pub mod ledger;
pub mod outcome;
pub mod tally;

use outcome::Outcome;
use rayon::prelude::*;

/// Subject of a campaign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Flights without failures: none may end badly.
    Spread,
    /// Flights with a failure: every stop must be justified, and none may be missing.
    Failures,
}

impl Kind {
    /// Flies the flight of a seed.
    pub fn fly(self, seed: u64) -> Outcome {
        match self {
            Self::Spread => outcome::of_spread(seed),
            Self::Failures => outcome::of_failure(seed),
        }
    }
}

/// Flies the seeds on all cores; calls `done` with the result of each flight as it ends, in any order.
pub fn fly(kind: Kind, seeds: &[u64], done: impl Fn(Outcome) + Sync) {
    seeds.par_iter().for_each(|seed| done(kind.fly(*seed)));
}
