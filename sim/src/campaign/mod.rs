//! Campaigns of very many flights: random scenarios from seeds, the result of each flight, and a summary.
//!
//! | module | what it says |
//! |---|---|
//! | [`dice`] | the scenario of a seed: parameters, trajectory, air, sensors, outages, failures |
//! | [`outcome`] | how one flight went, as the values of a row |
//! | [`rare`] | how near a flight came to the limits, for failures too rare to be counted |
//! | [`tally`] | percentiles and verdicts over all rows |
//!
//! A flight depends on its seed and on nothing else. Files, shards and the runs themselves are those of `bessemer-campaign`.

pub mod dice;
pub mod outcome;
pub mod rare;
pub mod tally;

use bessemer_campaign::rare::Rare;
use bessemer_campaign::{Column, Replay, Value, fingerprint};
use bessemer_lanes::LANES;

use crate::scenario::Scenario;
pub use bessemer_campaign::Campaign;
use outcome::Outcome;

/// Subject of a campaign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Flights without failures: none may end badly.
    Spread,
    /// Flights with a failure: every stop must be justified, and none may be missing.
    Failures,
}

/// Every campaign, for a program of them.
pub const ALL: [&dyn Campaign; 2] = [&Kind::Spread, &Kind::Failures];

/// Version of the simulated world. Raise it when a flight of the same models changes: a test compares the committed flights.
const VERSION: u32 = 2;

/// Address of the ground station while it shows a recording; its links of seeds begin with it.
const STATION: &str = "http://127.0.0.1:8080";

/// Names and texts of the models' files.
macro_rules! sources {
    ($($name:literal)*) => {
        [$(($name, include_str!(concat!("../../../models/src/", $name)))),*]
    };
}

/// Names and texts of all files in `models/src/`.
pub const MODELS: [(&str, &str); 36] = sources! {
    "airframe.rs"
    "attitude.rs"
    "attitude_filter.rs"
    "axis_filter.rs"
    "calibration.rs"
    "cascade.rs"
    "clock_monitor.rs"
    "controller.rs"
    "crash_predictor.rs"
    "estimator.rs"
    "expectation.rs"
    "feed_forward.rs"
    "gate.rs"
    "geometric.rs"
    "geometry.rs"
    "height.rs"
    "horizontal.rs"
    "lib.rs"
    "logger.rs"
    "low_pass.rs"
    "mixer.rs"
    "onboard.rs"
    "packet.rs"
    "parameters.rs"
    "plant.rs"
    "printed.rs"
    "receiver.rs"
    "reference_generator.rs"
    "sender.rs"
    "shaper.rs"
    "signals.rs"
    "siphash.rs"
    "stuck.rs"
    "touch_down.rs"
    "trajectory.rs"
    "tuning.rs"
};

impl Kind {
    /// Returns the scenario of a seed.
    pub fn scenario(self, seed: u64) -> Scenario {
        match self {
            Self::Spread => dice::scenario(seed),
            Self::Failures => dice::failing(seed),
        }
    }

    /// Flies the flight of a seed.
    pub fn fly(self, seed: u64) -> Outcome {
        match self {
            Self::Spread => outcome::of_spread(seed),
            Self::Failures => outcome::of_failure(seed),
        }
    }
}

impl Campaign for Kind {
    fn kind(&self) -> &str {
        match self {
            Self::Spread => "spread",
            Self::Failures => "failures",
        }
    }

    fn version(&self) -> u32 {
        VERSION
    }

    fn models(&self) -> String {
        fingerprint(&MODELS.map(|(_, text)| text))
    }

    fn columns(&self) -> Vec<Column> {
        outcome::columns()
    }

    fn run(&self, seed: u64) -> Result<Vec<Value>, String> {
        Ok(self.fly(seed).values())
    }

    fn together(&self) -> usize {
        // Vectors of two numbers are no faster than one flight after the other.
        if cfg!(target_feature = "avx2") { LANES } else { 1 }
    }

    fn run_together(&self, seeds: &[u64]) -> Vec<Result<Vec<Value>, String>> {
        let outcomes = match self {
            Self::Spread => outcome::all_of_spread(seeds),
            Self::Failures => outcome::all_of_failures(seeds),
        };
        outcomes.into_iter().map(|outcome| Ok(outcome.values())).collect()
    }

    fn fault(&self, row: &[Value]) -> Option<String> {
        let outcome = Outcome::of(0, row)?;
        tally::fault(*self, &outcome).map(str::to_owned)
    }

    fn replay(&self, seed: u64) -> Replay {
        let command = format!("cargo xtask replay --page --campaign {} --seed {seed}", self.kind());
        Replay { command, link: format!("{STATION}/seed/{}/{seed}", self.kind()) }
    }
    fn rare(&self) -> Option<&dyn Rare> {
        match self {
            Self::Spread => Some(&rare::Envelope),
            Self::Failures => None,
        }
    }
}
