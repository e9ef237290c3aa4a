//! `cargo xtask gen`: what `cargo bessemer gen` does, for this repository's models.
//!
//! Invariant: the one place that calls it. (`gen` is a reserved word, hence the module's name.)
//!
//! What it must not know: how C is made.

use crate::args::Mode;
use crate::error::{Error, Outcome};
use bessemer_project::Wanted;
use std::io::IsTerminal;
use std::path::Path;

/// The package whose C is committed.
const MODELS: &str = "models";

/// Writes generated/ anew, or compares it, for the workspace at `root`; `explain`: says which checks are left.
///
/// # Errors
/// What the models, the compiler or the file system said, and that generated/ is stale, when comparing.
pub fn run(root: &Path, mode: Mode, explain: bool) -> Result<Outcome, Error> {
    let colour = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    let (package, check) = (Some(MODELS), mode == Mode::Check);
    let wanted = Wanted { package, check, explain, colour };
    anstream::print!("{}", bessemer_project::generate(root, wanted)?);
    Ok(Outcome::Good)
}
