//! Reasons why a goal is missed or a case exceeds its limit: texts in `bench/results/reasons.json`.
//!
//! Invariant: a reason explains the cases that it lists and no other. A case that exceeds its limit later, or beside another best routine, or by
//! more than before, has no reason until somebody writes one. A reason that no case needs any more is reported ([`unsettled`]).
//!
//! This module must neither set limits and goals nor measure figures: `above`, `goals` and `results` do.

use std::fmt;

use serde::Deserialize;

use super::results::Results;
use super::{above, goals};

/// All reasons of the file.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reasons {
    above: Vec<OfCases>,
    missed: Vec<OfGoals>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct OfCases {
    /// The reason; `None` if the cases are known to exceed their limits for an unknown reason.
    why: Option<String>,
    cases: Vec<Place>,
}

/// A small case on a machine, and the best of the other contenders there, by their names in the results.
#[derive(Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Place {
    /// Name of the machine, such as `a9`.
    pub machine: String,
    /// Name of the case, such as `product_f32_6`.
    pub case: String,
    /// Name of the best contender, such as `eigen`.
    pub best: String,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} on {} beside {}", self.case, self.machine, self.best)
    }
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct OfGoals {
    why: String,
    goals: Vec<Missed>,
}

/// A missed goal, and the largest figure for which the reason is valid.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Missed {
    /// Description of the goal, as in the report.
    pub what: String,
    /// The figure for which the reason was written; a worse one needs a new reason.
    pub up_to: f64,
}

impl Reasons {
    /// Reads the committed file.
    ///
    /// # Errors
    ///
    /// The file is missing or invalid; with line and column.
    pub fn committed() -> Result<Reasons, String> {
        let path = bessemer_tests::root().join("bench/results/reasons.json");
        let text = std::fs::read_to_string(&path).map_err(|error| error.to_string());
        let read = |text: String| Reasons::from_json(&text).map_err(|error| error.to_string());
        text.and_then(read).map_err(|error| format!("`{}`: {error}", path.display()))
    }

    /// Parses the text of such a file.
    ///
    /// # Errors
    ///
    /// The text is invalid.
    pub fn from_json(text: &str) -> Result<Reasons, serde_json::Error> {
        serde_json::from_str(text)
    }

    /// Returns the reason why a case exceeds its limit.
    pub fn of_case(&self, place: &Place) -> Option<&str> {
        self.above.iter().find(|reason| reason.cases.contains(place))?.why.as_deref()
    }

    /// Returns all cases that are known to exceed their limits, with or without a reason.
    pub fn cases(&self) -> impl Iterator<Item = &Place> {
        self.above.iter().flat_map(|reason| &reason.cases)
    }

    /// Returns the reason why a goal is missed.
    pub fn of_goal(&self, what: &str) -> Option<&str> {
        let speaks = |reason: &&OfGoals| reason.goals.iter().any(|goal| goal.what == what);
        Some(&self.missed.iter().find(speaks)?.why)
    }

    /// Returns all goals that are known to be missed.
    pub fn goals(&self) -> impl Iterator<Item = &Missed> {
        self.missed.iter().flat_map(|reason| &reason.goals)
    }
}

/// Returns a line for each case above its limit and each missed goal without a reason, and for each reason that is not
/// needed.
pub fn unsettled(results: &Results, reasons: &Reasons) -> Vec<String> {
    let mut lines = above::unsettled(results, reasons);
    lines.extend(goals::unsettled(results, reasons));
    lines
}
