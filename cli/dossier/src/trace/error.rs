//! Errors of a search for a counterpart, each with a remedy.

use std::path::PathBuf;

/// Reason why a line has no counterpart.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The text names no line.
    #[error("`{said}` names no line")]
    NoLine {
        /// The user's text.
        said: String,
    },
    /// The folder of the C is not there, or has no map.
    #[error("`{path}` has no C with maps")]
    NoFolder {
        /// The folder.
        path: PathBuf,
    },
    /// No file of the folder has the name.
    #[error("the C has no file `{name}`")]
    NoFile {
        /// The user's text.
        name: String,
        /// Names that resemble it.
        like: Vec<String>,
    },
    /// No C comes from the Rust file.
    #[error("no C comes from `{name}`")]
    NoRust {
        /// The user's text.
        name: String,
        /// Names that resemble it.
        like: Vec<String>,
    },
    /// Several files have the name.
    #[error("`{name}` may be {}", known.join(" or "))]
    Several {
        /// The user's text.
        name: String,
        /// The files.
        known: Vec<String>,
    },
    /// The file is shorter.
    #[error("`{file}` has {last} lines, and no line {line}")]
    Beyond {
        /// Name of the file.
        file: String,
        /// The line that the user named.
        line: u32,
        /// The last line.
        last: u32,
    },
    /// Nothing of the Rust file becomes C.
    #[error("`{file}:{line}` has no C")]
    NoCounterpart {
        /// Name of the file.
        file: String,
        /// The line.
        line: u32,
    },
    /// A map is not one.
    #[error("`{path}`, line {line}: this is no line of a map")]
    Map {
        /// The map.
        path: PathBuf,
        /// The line.
        line: usize,
    },
    /// A map is of another C.
    #[error(
        "`{file}` was changed after its generation: its map has line {line}, the file has {last}"
    )]
    Edited {
        /// Name of the C file.
        file: String,
        /// Line in the map.
        line: u32,
        /// Last line of the C.
        last: u32,
    },
    /// A file or folder could not be read.
    #[error("`{path}`: {source}")]
    File {
        /// The file or folder.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
}

impl Error {
    /// Returns a step that resolves the error.
    pub fn remedy(&self) -> Option<String> {
        let listed = |like: &[String], otherwise: &str| match like {
            [] => otherwise.to_owned(),
            like => format!("choose from {}", like.join(", ")),
        };
        Some(match self {
            Error::NoLine { .. } => {
                "write the file and the line: `cargo bessemer where generated/motor.c:40`"
                    .to_owned()
            }
            Error::NoFolder { .. } => "generate it first: `cargo bessemer gen`".to_owned(),
            Error::NoFile { like, .. } => {
                listed(like, "name a file of the folder that `cargo bessemer gen` writes")
            }
            Error::NoRust { like, .. } => {
                listed(like, "name a source of the models, as a path from the workspace")
            }
            Error::Several { .. } => "write more of the path".to_owned(),
            Error::NoCounterpart { .. } => "name a line of a function that becomes C".to_owned(),
            Error::Map { .. } | Error::Edited { .. } => {
                "write the C anew: `cargo bessemer gen`".to_owned()
            }
            Error::Beyond { .. } | Error::File { .. } => return None,
        })
    }
}
