//! Flight logs as recordings: ULog of PX4 (`ulog`), DataFlash of ArduPilot (`dataflash`) and blackbox of Betaflight
//! (`blackbox`). A table of `bessemer.toml` maps them to the parameters of an entry point (`mapped`), and they are resampled to
//! its period (`resampled`).
//!
//! The readers are written here, a page for each format. The crates do not fit: `px4-ulog` 0.6 returns the prefix of a damaged
//! log without a word, `ardupilot-binlog` 0.2 has no instances, and `blackbox-log` 0.4 calls itself unready and brings seven
//! dependencies.
//!
//! Invariants: nothing is dropped in silence, and no input panics. Must not know: legs.

mod blackbox;
mod bytes;
mod dataflash;
mod error;
mod log;
mod mapped;
mod resampled;
mod ulog;

use bessemer_backend::c::interface::Interface;
use bessemer_project::Project;
use bessemer_project::inputs::{Inputs, Period};

pub use error::Wrong;

use super::{Table, Wanted};
use log::Log;

/// An entry point's part of `bessemer.toml`.
pub struct Mapping<'p> {
    /// Names of the entry point: in the C, in the Rust, and its component's in the C.
    pub names: Vec<String>,
    /// Names of all entry points and components.
    pub known: Vec<String>,
    /// The tables `[inputs.…]`.
    pub inputs: &'p [Inputs],
    /// The table `[periods]`.
    pub periods: &'p [Period],
}

impl<'p> Mapping<'p> {
    /// The part of the entry point with this name in the Rust.
    pub fn of(project: &'p Project, face: &Interface, entry: &str) -> Mapping<'p> {
        let (mut names, mut known) = (Vec::new(), Vec::new());
        for it in &face.entries {
            // A component is called as its type without the end.
            let component = it.parameters.first().map(|it| it.value.ty.as_str());
            let component = component.map(|it| it.strip_suffix("_t").unwrap_or(it).to_owned());
            let own = [Some(it.name.clone()), Some(it.rust.clone()), component];
            for name in own.into_iter().flatten() {
                if it.rust == entry {
                    names.push(name.clone());
                }
                if !known.contains(&name) {
                    known.push(name);
                }
            }
        }
        let (inputs, periods) = (&project.settings.inputs, &project.settings.periods);
        Mapping { names, known, inputs, periods }
    }
}

/// Reader of a kind of log; the function says of which topics samples are wanted.
type Reader = fn(&[u8], &dyn Fn(&str) -> bool) -> Result<Log, Wrong>;

/// The reader of a file, if it is a flight log.
fn reader(file: &[u8]) -> Option<Reader> {
    let readers: [(&[u8], Reader); 3] = [
        (ulog::MAGIC, ulog::read),
        (dataflash::MAGIC, dataflash::read),
        (blackbox::MAGIC, blackbox::read),
    ];
    readers.into_iter().find(|(magic, _)| file.starts_with(magic)).map(|(_, reader)| reader)
}

/// Reads the calls of an entry point; none if the file is no flight log.
pub(super) fn read(
    file: &[u8],
    wanted: &Wanted<'_>,
    mapping: &Mapping<'_>,
) -> Option<Result<Table, Wrong>> {
    let reader = reader(file)?;
    Some(mapped::read(|topics| reader(file, topics), wanted, mapping))
}

#[cfg(test)]
mod tests;
