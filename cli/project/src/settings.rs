//! What a user decides about the C of a package.

use std::path::PathBuf;

use bessemer_codegen::compile::Options;

/// What a user decides about the C of a package.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// The folder of the C, from that of the file; none: `generated` of the workspace.
    pub output: Option<PathBuf>,
    /// The licence of the C, if it is not the package's.
    pub license: Option<String>,
    /// What the compiler is told.
    pub options: Options,
    /// What must not be exceeded.
    pub limits: Limits,
}

/// What must not be exceeded.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of stack of an entry point.
    pub stack_bytes: Option<Limit>,
    /// Bytes of a component's state.
    pub state_bytes: Option<Limit>,
    /// Checks that are left in an entry point.
    pub checks: Option<Limit>,
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
