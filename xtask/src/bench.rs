//! `cargo xtask bench`: a place kept free for the measurements.
//!
//! Invariant: while nothing is measured, nothing is printed that could pass for a measurement.

use crate::args::Bench;
use crate::error::{Error, Outcome};

/// Says that there are no measurements yet.
///
/// # Errors
/// Always [`Error::NotYet`].
pub fn run(wanted: &Bench) -> Result<Outcome, Error> {
    let Bench { quick: _ } = wanted;
    Err(Error::NotYet {
        command: "bench",
        with: "the linear algebra",
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_does_not_pretend() {
        let outcome = run(&Bench { quick: true });
        assert!(
            matches!(&outcome, Err(error) if error.code() == 2),
            "{outcome:?}"
        );
    }
}
