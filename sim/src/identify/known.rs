//! Prior knowledge of an aircraft before it flies a trajectory: its data sheet, and the findings of a hover.
//!
//! The way of a user: hover, keep the log, identify, and give the software the coefficients that were found.

use super::fit::fit;
use super::logged::Logged;
use super::segments::Segments;
use super::with_coefficients;
use crate::computer::Native;
use crate::noise::{Purpose, Stream};
use crate::recording::{self, Log};
use crate::scenario::{Scenario, point};
use crate::voyage::fly;
use models::{Airframe, Mode};
use std::collections::BTreeMap;
use std::error::Error;

/// Time constant of the Mambo's motors by their data sheet, s.
pub const LAG: f64 = 0.015;

/// A hover of 24 s of an aircraft each of whose thrust coefficients lies up to 10 % off the data sheet.
pub fn unknown_hover(seed: u64) -> Scenario {
    let mut dice = Stream::new(seed, Purpose::Dice);
    let mut scenario = Scenario::mambo(&[point(0.0, 0.0, 0.0, 1.0, 0.0)], 24.0, Mode::ClosedLoop);
    let sheet = scenario.airframe.thrust_coefficients;
    let coefficients: Vec<f64> = (0..4).map(|n| sheet[n] * dice.between(0.9, 1.1)).collect();
    scenario.airframe = with_coefficients(&scenario.airframe, &coefficients);
    scenario.seed = seed;
    scenario
}

/// The log of a flight, as its file would give it.
///
/// # Errors
/// What the log says when it is written and read.
pub fn log_of(scenario: &Scenario) -> Result<Logged, Box<dyn Error>> {
    let voyage = fly(scenario, &mut Native::default());
    let log = Log::of(&recording::mcap(&voyage, &BTreeMap::new())?, "hover".into())?;
    Ok(Logged::of(&log, LAG)?)
}

/// Returns the airframe that the software should assume after a logged hover: the data sheet with coefficients fitted
/// to the hover.
///
/// # Errors
/// What the optimiser said.
pub fn identified(hover: &Logged) -> Result<Airframe, Box<dyn Error>> {
    let sheet = Airframe::mambo();
    let first: [f64; 4] = std::array::from_fn(|n| sheet.thrust_coefficients[n]);
    let found =
        fit(&Segments::of(hover, &sheet), &first, |_, _| ()).map_err(|error| error.to_string())?;
    Ok(with_coefficients(&sheet, &found.coefficients))
}

/// By how much the worst of the coefficients is off, as a fraction.
pub fn worst_off(found: &[f64], truth: &[f64]) -> f64 {
    found.iter().zip(truth).map(|(found, truth)| (found / truth - 1.0).abs()).fold(0.0, f64::max)
}
