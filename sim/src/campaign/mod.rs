//! Very many flights: which chance makes of a seed, how each went, and what all of them come to.
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
    /// Nothing breaks: no flight may end badly.
    Spread,
    /// Something breaks in each: every stop must be true, and none may be missed.
    Failures,
}

impl Kind {
    /// The flight of a seed.
    pub fn fly(self, seed: u64) -> Outcome {
        match self {
            Self::Spread => outcome::of_spread(seed),
            Self::Failures => outcome::of_failure(seed),
        }
    }
}

/// Flies the seeds on all cores; `done` hears of each flight as it ends, in any order.
pub fn fly(kind: Kind, seeds: &[u64], done: impl Fn(Outcome) + Sync) {
    seeds.par_iter().for_each(|seed| done(kind.fly(*seed)));
}
