//! The job of a generation: its package, its output folder, its options.

use std::path::PathBuf;

use crate::compile::Options;

/// The job of a generation: its package, its output folder, its options.
#[derive(Clone, Debug)]
pub struct Job {
    /// The root of the workspace.
    pub root: PathBuf,
    /// The package of models.
    pub package: String,
    /// The folder of the C, which belongs to the generator.
    pub output: PathBuf,
    /// Compare instead of writing.
    pub check: bool,
    /// The user's decisions about the C.
    pub options: Options,
    /// The licence of the C, as an SPDX expression, if it is not the package's.
    pub license: Option<String>,
    /// Colour in diagnostics and differences.
    pub colour: bool,
    /// The version that the manifest names: the tool's.
    pub version: String,
}

impl Job {
    /// Generates `package` of the workspace at `root` into its `generated/`.
    pub fn new(root: impl Into<PathBuf>, package: &str) -> Job {
        let root = root.into();
        let output = root.join("generated");
        let version = env!("CARGO_PKG_VERSION").to_owned();
        let (package, options) = (package.to_owned(), Options::default());
        Job { root, package, output, check: false, options, license: None, colour: false, version }
    }
}
