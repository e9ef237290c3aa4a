//! Input of a generation: package, output folder, options.

use std::path::PathBuf;

use crate::compile::Options;

/// Input of a generation: package, output folder, options.
#[derive(Clone, Debug)]
pub struct Job {
    /// The root of the workspace.
    pub root: PathBuf,
    /// The package of models.
    pub package: String,
    /// Output folder, which only the generator may write.
    pub output: PathBuf,
    /// True to compare the C with the folder instead of writing it.
    pub check: bool,
    /// User's options for the C.
    pub options: Options,
    /// SPDX licence expression of the C, if it differs from the package's.
    pub license: Option<String>,
    /// True for colour in diagnostics and differences.
    pub colour: bool,
    /// Version of the tool, for the manifest.
    pub version: String,
}

impl Job {
    /// Creates a job for `package` of the workspace at `root`, with the output folder `generated/`.
    pub fn new(root: impl Into<PathBuf>, package: &str) -> Job {
        let root = root.into();
        let output = root.join("generated");
        let version = env!("CARGO_PKG_VERSION").to_owned();
        let (package, options) = (package.to_owned(), Options::default());
        Job { root, package, output, check: false, options, license: None, colour: false, version }
    }
}
