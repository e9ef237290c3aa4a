//! Tables that the whole back end reads, and the requirements of one file.

use std::collections::BTreeSet;

use bessemer_ir::{ConstId, FunctionId, Module};

use super::analysis::Faults;
use super::helpers::Helper;
use super::names::Names;

/// Requirements of the functions in a file: helpers, constants and headers.
#[derive(Clone, Debug, Default)]
pub struct Uses {
    /// Header name that identifies the file.
    pub file: String,
    /// Helper functions.
    pub helpers: BTreeSet<Helper>,
    /// Called functions.
    pub called: BTreeSet<FunctionId>,
    /// Named constants.
    pub consts: BTreeSet<ConstId>,
    /// Emitted headers.
    pub headers: BTreeSet<String>,
    /// Headers of C's library.
    pub system: BTreeSet<&'static str>,
    /// True if the macro for unrolling is needed.
    pub unroll: bool,
}

/// Data shared by the lowering of all functions.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// The module.
    pub module: &'a Module,
    /// Names of all items.
    pub names: &'a Names,
    /// Set of functions that can fault.
    pub faults: &'a Faults,
}
