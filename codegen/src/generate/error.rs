//! Why nothing was generated, and what to do about it.

use std::path::PathBuf;

/// Why nothing was generated.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The models do not compile; what rustc said, in the author's terms.
    #[error("{0}")]
    Models(String),
    /// The models compile, but are not what C can be made of.
    #[error("{0}")]
    Refused(String),
    /// The committed C is not what the models give; the differences.
    #[error("{0}")]
    Stale(String),
    /// The folder holds files that the generator did not write.
    #[error("`{folder}` holds `{file}`, which Bessemer did not write")]
    Foreign {
        /// The folder.
        folder: PathBuf,
        /// The first such file.
        file: String,
    },
    /// A program could not be run.
    #[error("cannot run `{program}`: {source}")]
    Run {
        /// Which.
        program: String,
        /// Why.
        source: std::io::Error,
    },
    /// The package's tree could not be read: tool and DSL do not fit together.
    #[error("the tree of `{package}` cannot be read: {reason}")]
    Tree {
        /// The package.
        package: String,
        /// Why.
        reason: String,
    },
    /// A file could not be read or written.
    #[error("`{path}`: {source}")]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}

impl Error {
    /// What to do about it.
    pub fn remedy(&self) -> Option<&'static str> {
        match self {
            Error::Stale(_) => Some("cargo xtask gen"),
            Error::Foreign { .. } => Some("move it elsewhere, or generate into another folder"),
            Error::Tree { .. } => {
                Some("use the same version of `bessemer` and of `bessemer-codegen`")
            }
            _ => None,
        }
    }
}
