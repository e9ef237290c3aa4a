//! `cargo xtask sim`: hands over to the `sim` crate.
//!
//! Invariant: the one place that calls it.
//!
//! What it must not know: the plant, the flights' contents.

use crate::args::Sim;
use crate::error::{Error, Outcome};

/// Flies the flight that was asked for.
///
/// # Errors
/// [`Error::NotYet`] while the simulator is not wired.
pub fn run(wanted: &Sim) -> Result<Outcome, Error> {
    // To wire: look `wanted.flight` up among the flights of the `sim` crate, or list them.
    let _ = wanted;
    Err(Error::NotYet {
        command: "sim",
        with: "the simulator",
    })
}
