//! `cargo xtask gen`: hands over to the generator's own command-line library.
//!
//! Invariant: the one place that calls it. (`gen` is a reserved word, hence the module's name.)
//!
//! What it must not know: how C is made.

use crate::args::Mode;
use crate::error::{Error, Outcome};
use bessemer_codegen::generate::{self, Job};
use std::io::IsTerminal;
use std::path::Path;

/// The package whose C is committed.
const MODELS: &str = "models";

/// Writes generated/ anew, or compares it, for the workspace at `root`; `explain`: says which checks are left.
///
/// # Errors
/// What the models, the compiler or the file system said; [`generate::Error::Stale`] when comparing finds a
/// difference.
pub fn run(root: &Path, mode: Mode, explain: bool) -> Result<Outcome, Error> {
    let mut job = Job::new(root, MODELS);
    job.check = mode == Mode::Check;
    job.colour = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    let summary = generate::generate(&job)?;
    if !job.check {
        anstream::print!("{}", generate::table(&summary.compiled));
        let files = summary.compiled.files.len();
        match summary.changed.len() {
            0 => anstream::println!("\n{files} files in generated/, all up to date"),
            changed => anstream::println!(
                "\n{files} files in generated/, {changed} changed: {}",
                summary.changed.join(" ")
            ),
        }
    }
    if explain {
        anstream::print!("\n{}", generate::explanation(&summary.compiled));
    }
    Ok(Outcome::Good)
}
