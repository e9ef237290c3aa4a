//! Prior knowledge of an aircraft before it flies a trajectory: its data sheet, and the coefficients from a hover.
//!
//! It follows the steps of a user: hover, keep the log, identify, and give the software the identified coefficients.

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

/// Returns the scenario of a 24 s hover of an aircraft whose thrust coefficients differ by up to 10 % from the data
/// sheet.
pub fn unknown_hover(seed: u64) -> Scenario {
    let mut dice = Stream::new(seed, Purpose::Dice);
    let mut scenario = Scenario::mambo(&[point(0.0, 0.0, 0.0, 1.0, 0.0)], 24.0, Mode::ClosedLoop);
    let sheet = scenario.airframe.thrust_coefficients;
    let coefficients: Vec<f64> = (0..4).map(|n| sheet[n] * dice.between(0.9, 1.1)).collect();
    scenario.airframe = with_coefficients(&scenario.airframe, &coefficients);
    scenario.seed = seed;
    scenario
}

/// Returns the log of a flight, as read from its file.
///
/// # Errors
///
/// An error when the log is written or read.
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

/// Returns the largest relative error of the coefficients.
pub fn worst_off(found: &[f64], truth: &[f64]) -> f64 {
    found.iter().zip(truth).map(|(found, truth)| (found / truth - 1.0).abs()).fold(0.0, f64::max)
}
