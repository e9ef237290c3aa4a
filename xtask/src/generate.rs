//! `cargo xtask gen`: `cargo bessemer gen` for this repository's models.
//!
//! Invariant: this is the only caller. (`gen` is a reserved word, hence the module's name.)
//!
//! What it must not know: how C is generated.

use crate::args::{Gen, MessageFormat, Mode};
use crate::error::{Error, Outcome};
use bessemer_project::Wanted;
use std::io::IsTerminal;
use std::path::Path;

/// The package whose C is committed.
const MODELS: &str = "models";

/// Writes generated/ anew, or compares it, for the workspace at `root`.
///
/// # Errors
/// Errors of the models, the compiler or the file system, and a stale generated/ when comparing. For an editor,
/// what the models are reported is no error of the command's: it is printed.
pub fn run(root: &Path, wanted: &Gen) -> Result<Outcome, Error> {
    let for_tools = wanted.message_format == MessageFormat::Json;
    let colour =
        !for_tools && std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    let (package, check) = (Some(MODELS), wanted.mode() == Mode::Check);
    let asked = Wanted { package, check, explain: wanted.explain, colour };
    let said = bessemer_project::said(bessemer_project::generate(root, asked), for_tools)?;
    anstream::eprint!("{}", said.remarks);
    anstream::print!("{}", said.text);
    Ok(if said.good { Outcome::Good } else { Outcome::Bad })
}
