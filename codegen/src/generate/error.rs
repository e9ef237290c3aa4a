//! Errors of a generation, and their remedies.

use std::io::ErrorKind;
use std::path::PathBuf;

use bessemer_frontend::diagnostic::Told;

/// Errors of a generation.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The models do not compile; rustc's errors in the author's terms.
    #[error("{0}")]
    Models(Told),
    /// The models compile, but the DSL cannot express them in C.
    #[error("{0}")]
    Refused(Told),
    /// The committed C differs from the generated C; the differences.
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
    /// The output folder is a file.
    #[error("`{path}` is a file, not a folder")]
    NotAFolder {
        /// Path of the file.
        path: PathBuf,
    },
    /// The folder has the C of another package.
    #[error("`{folder}` holds the C of the package `{package}`")]
    Other {
        /// The folder.
        folder: PathBuf,
        /// Name of that package.
        package: String,
    },
    /// There is no workspace, or cargo cannot read it.
    #[error("`{folder}`: {said}")]
    Workspace {
        /// Folder of the search.
        folder: PathBuf,
        /// Message of cargo.
        said: String,
    },
    /// The workspace has no package of this name.
    #[error("the workspace has no package `{package}`")]
    NoPackage {
        /// Requested name.
        package: String,
        /// Names of the existing packages.
        known: Vec<String>,
    },
    /// The package has no library.
    #[error("the package `{package}` has no library")]
    NoLibrary {
        /// Name of the package.
        package: String,
    },
    /// The package's library cannot be linked with Rust code.
    #[error("the library of `{package}` cannot be linked")]
    NotLinked {
        /// Name of the package.
        package: String,
    },
    /// The package does not name the DSL among its dependencies.
    #[error("the package `{package}` does not depend on `bessemer`")]
    NotOfTheDsl {
        /// Name of the package.
        package: String,
    },
    /// Members of one workspace require different versions of the `f32` functions.
    #[error(
        "`{with}` enables the feature `single` of `bessemer` and `{without}` does not, but cargo builds `bessemer` once for both"
    )]
    Singles {
        /// Package with the feature.
        with: String,
        /// Package without it.
        without: String,
    },
    /// The package has no licence for the C.
    #[error("the package `{package}` has no `license`, which each file of the C names")]
    NoLicense {
        /// Name of the package.
        package: String,
    },
    /// The licence is not a valid line of a C comment.
    #[error("the licence of the package `{package}` cannot be written in a C comment: {license:?}")]
    License {
        /// Name of the package.
        package: String,
        /// Text of the licence.
        license: String,
    },
    /// Nothing in the package is marked.
    #[error("nothing in the package `{package}` is marked for C")]
    NoModels {
        /// Name of the package.
        package: String,
    },
    /// A program could not be run.
    #[error("cannot run `{program}`: {source}")]
    Run {
        /// Name of the program.
        program: String,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// The package's tree could not be read: the versions of tool and DSL differ.
    #[error("the tree of `{package}` cannot be read: {reason}")]
    Tree {
        /// The package.
        package: String,
        /// Message of the parser.
        reason: String,
    },
    /// A file could not be read or written.
    #[error("`{path}`: {source}")]
    File {
        /// Path of the file.
        path: PathBuf,
        /// Error of the operating system.
        source: std::io::Error,
    },
}

impl Error {
    /// Returns a remedy, if there is one.
    pub fn remedy(&self) -> Option<String> {
        Some(match self {
            Error::Stale(_) => "run `gen` again, without `--check`".to_owned(),
            Error::Foreign { .. } => "move it elsewhere, or generate into another folder".to_owned(),
            Error::NotAFolder { .. } => {
                "move it elsewhere, or generate into another folder".to_owned()
            }
            Error::File { source, .. } => match source.kind() {
                ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
                    "make it writable, or generate into another folder: `output = \"…\"` in bessemer.toml".to_owned()
                }
                ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge => {
                    "free some space there; the previous output is unchanged".to_owned()
                }
                ErrorKind::InvalidFilename => {
                    "generate into another folder: `output = \"…\"` in bessemer.toml".to_owned()
                }
                _ => return None,
            },
            Error::Other { .. } => "set a separate folder for each package: `output = \"…\"` in its bessemer.toml".to_owned(),
            Error::Workspace { said, .. } if said.starts_with("could not find") => {
                "run it in the folder of a package, or create one: `cargo bessemer new motor`".to_owned()
            }
            Error::NoPackage { known, .. } if known.is_empty() => return None,
            Error::NoPackage { known, .. } => format!("choose from {}", known.join(", ")),
            Error::NoLibrary { .. } => "move the models to `src/lib.rs`".to_owned(),
            Error::NotLinked { .. } => {
                "add \"rlib\" to `crate-type` in the `[lib]` section of its Cargo.toml".to_owned()
            }
            Error::NotOfTheDsl { .. } => {
                "add `bessemer` under `[dependencies]` in its Cargo.toml, by that name".to_owned()
            }
            Error::Singles { .. } => {
                "enable it in both: `bessemer = { …, features = [\"single\"] }` under `[workspace.dependencies]`, and \
                 `bessemer = { workspace = true }` in each; or make one a workspace of its own"
                    .to_owned()
            }
            Error::NoLicense { .. } => {
                "write `license = \"MIT OR Apache-2.0\"`, or yours, into the `[package]` section of its Cargo.toml".to_owned()
            }
            Error::License { .. } => {
                "write it in one line, without `/*` and `*/`: `license = \"MIT OR Apache-2.0\"`".to_owned()
            }
            Error::NoModels { .. } => {
                "mark a struct and its `impl` `#[component]`, or a function `#[function]`; and name its file with `mod` in `src/lib.rs`".to_owned()
            }
            Error::Tree { .. } => {
                "use the same version of `bessemer` and of `bessemer-codegen`".to_owned()
            }
            _ => return None,
        })
    }
}
