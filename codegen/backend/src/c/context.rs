//! The lookup tables of the whole back end, and the includes and helpers that one file needs.

use std::collections::BTreeSet;

use bessemer_ir::{ConstId, FunctionId, Module};

use super::analysis::Faults;
use super::helpers::Helper;
use super::names::Names;

/// The helpers, constants and headers that the functions of a file need.
#[derive(Clone, Debug, Default)]
pub struct Uses {
    /// The file, by its header.
    pub file: String,
    /// Helper functions.
    pub helpers: BTreeSet<Helper>,
    /// Functions that the text calls.
    pub called: BTreeSet<FunctionId>,
    /// Named constants.
    pub consts: BTreeSet<ConstId>,
    /// Emitted headers.
    pub headers: BTreeSet<String>,
    /// Headers of C's library.
    pub system: BTreeSet<&'static str>,
    /// The macro that asks the compiler to unroll a loop.
    pub unroll: bool,
}

/// Data shared by the lowering of all functions.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// The module.
    pub module: &'a Module,
    /// Its names.
    pub names: &'a Names,
    /// Set of functions that can fault.
    pub faults: &'a Faults,
}
