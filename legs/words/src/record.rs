//! Calls of an entry point that a test makes, for the coverage of a dossier.
//!
//! `cargo bessemer dossier` sets [`FOLDER`] for the tests that it runs. Each [`Recorder`] writes one file there: a line
//! with the entry point and the number of words of a call, then the words of all calls, least significant byte first.
//! Without the variable nothing is stored or written.

use std::any::type_name;
use std::io::{Error, ErrorKind, Result};
use std::path::{Path, PathBuf};

use bessemer::Plain;

use crate::{digest, words};

/// Variable with the folder for the files.
pub const FOLDER: &str = "BESSEMER_RECORD";

/// Calls of one component from its initial state on, written when the value is dropped.
#[derive(Debug)]
pub struct Recorder {
    calls: Calls,
    folder: Option<PathBuf>,
}

/// Recorded calls of an entry point.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Calls {
    /// Component and method, `Motor::step`.
    pub entry: String,
    /// The words of the arguments of each call, without the component.
    pub calls: Vec<Vec<u64>>,
}

impl Recorder {
    /// Begins a recording of the method `entry` of the component `C`.
    pub fn of<C>(entry: &str) -> Recorder {
        let calls = Calls { entry: format!("{}::{entry}", component::<C>()), calls: Vec::new() };
        Recorder { calls, folder: std::env::var_os(FOLDER).map(PathBuf::from) }
    }

    /// Adds a call, whose arguments after `self` are a tuple in their order. A reference is passed by its value.
    pub fn call<I: Plain>(&mut self, arguments: impl FnOnce() -> I) {
        if self.folder.is_some() {
            self.calls.calls.push(words(&arguments()));
        }
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        if let Some(folder) = &self.folder
            && let Err(error) = self.calls.write(folder)
        {
            eprintln!("the calls of {} are missing in the coverage: {error}", self.calls.entry);
        }
    }
}

/// Returns the name of a component without its module and parameters.
pub fn component<C>() -> &'static str {
    let path = type_name::<C>();
    path.split('<').next().and_then(|path| path.rsplit("::").next()).unwrap_or(path)
}

impl Calls {
    /// Writes the calls to a file of a folder, whose name follows from the calls.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn write(&self, folder: &Path) -> Result<()> {
        let width = self.calls.first().map_or(0, Vec::len);
        let words = self.calls.concat();
        let mut bytes = format!("{} {width}\n", self.entry).into_bytes();
        bytes.extend(words.iter().flat_map(|word| word.to_le_bytes()));
        let name = format!("{}-{:016x}", self.entry.replace("::", "-"), digest(&words));
        std::fs::write(folder.join(name), bytes)
    }

    /// Reads a file. A call without words is not counted, since it leaves none.
    ///
    /// # Errors
    /// An error of the file system, or [`ErrorKind::InvalidData`].
    pub fn read(path: &Path) -> Result<Calls> {
        let bytes = std::fs::read(path)?;
        let wrong = || Error::new(ErrorKind::InvalidData, "this is no recording of calls");
        let end = bytes.iter().position(|byte| *byte == b'\n').ok_or_else(wrong)?;
        let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
        let (entry, width) = head.rsplit_once(' ').ok_or_else(wrong)?;
        let width: usize = width.parse().map_err(|_| wrong())?;
        let (words, rest) = bytes[end + 1..].as_chunks::<8>();
        let words: Vec<u64> = words.iter().map(|bytes| u64::from_le_bytes(*bytes)).collect();
        if !rest.is_empty() || !words.len().is_multiple_of(width.max(1)) {
            return Err(wrong());
        }
        let calls = words.chunks(width.max(1)).map(<[u64]>::to_vec).collect();
        Ok(Calls { entry: entry.to_owned(), calls })
    }
}

/// Returns the files of a folder, in an order that does not depend on the run.
///
/// # Errors
/// An error of the file system.
pub fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let paths = std::fs::read_dir(folder)?.map(|file| file.map(|it| it.path()));
    let mut paths = paths.collect::<Result<Vec<_>>>()?;
    paths.sort();
    Ok(paths)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_written_is_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let calls = vec![vec![1, u64::MAX], vec![2, 0]];
        let written = Calls { entry: "Motor::step".to_owned(), calls };
        written.write(folder.path()).expect("a file");
        let path = files(folder.path()).expect("files").remove(0);
        assert_eq!(Calls::read(&path).expect("calls"), written);
        for bytes in [&b"Motor::step"[..], b"Motor::step x\n", b"Motor::step 2\n12345678"] {
            std::fs::write(&path, bytes).expect("a file");
            assert_eq!(Calls::read(&path).expect_err("damaged").kind(), ErrorKind::InvalidData);
        }
    }

    #[test]
    fn a_component_is_named_without_module_and_parameters() {
        assert_eq!(component::<std::collections::BTreeMap<u8, String>>(), "BTreeMap");
    }
}
