//! The settings of `bessemer.toml`: a user's decisions about the C of a package.

use std::path::PathBuf;

use bessemer_codegen::compile::Options;

use crate::inputs::{Inputs, Period};
use crate::outputs::Outputs;

/// A user's decisions about the C of a package.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// The folder of the C, from that of the file; none: `generated` of the workspace.
    pub output: Option<PathBuf>,
    /// The licence of the C, if it is not the package's.
    pub license: Option<String>,
    /// Tells whether the folder of the C also gets files for CMake and make.
    pub build_files: bool,
    /// Tells whether the folder also gets `interface.json`.
    pub interface: bool,
    /// Tells whether tables of the parameters come along in C.
    pub parameters: bool,
    /// The options of the compiler.
    pub options: Options,
    /// The limits.
    pub limits: Limits,
    /// Sources of the inputs of entry points in flight logs.
    pub inputs: Vec<Inputs>,
    /// Topics to which the results of entry points go.
    pub outputs: Vec<Outputs>,
    /// Periods of entry points.
    pub periods: Vec<Period>,
}

/// Limits that no entry point may exceed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of stack of an entry point.
    pub stack_bytes: Option<Limit>,
    /// Bytes of a component's state.
    pub state_bytes: Option<Limit>,
    /// Checks that are left in an entry point.
    pub checks: Option<Limit>,
    /// Instructions of a call of an entry point on an emulated processor.
    pub instructions: Option<Limit>,
    /// Estimate of the instructions of an entry point, by the model of the dossier.
    pub estimated_instructions: Option<Limit>,
    /// Bytes of instructions and constants of all the C on such a processor.
    pub text_bytes: Option<Limit>,
}

/// A limit and where it is set, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limit {
    /// The most.
    pub most: u32,
    /// Line in `bessemer.toml`.
    pub line: u32,
    /// Column there.
    pub column: u32,
}
