//! The commands: their arguments and output. Their computation is in the package `sim`.

pub mod campaign;
pub mod fly;
pub mod identify;

use std::error::Error;

/// True if everything was as expected; an error if that could not be determined.
pub type Outcome = Result<bool, Box<dyn Error>>;

/// Writes a file; an error includes its name.
pub fn write(path: &std::path::Path, content: impl AsRef<[u8]>) -> Result<(), Box<dyn Error>> {
    std::fs::write(path, content).map_err(|error| format!("`{}`: {error}", path.display()).into())
}
