//! The C back end: explicit IR in, C99 files out.
//!
//! Lowering ([`lower`]) → C tree ([`tree`]) → printer ([`print`]) → file shells ([`shell`]). [`names`] determines
//! every identifier before, and serves callers of the emitted C.
//!
//! Invariants: equal modules give equal bytes. The text of a function depends only on that function, the signatures
//! of its callees, and its types. The C has no line numbers, dates or versions; no state, no heap, no recursion;
//! every loop is bounded. This module knows nothing of the front end, and does not change the IR.

mod analysis;

mod ascii;
mod asked;
mod assemble;
mod choices;
mod comments;
mod const_names;
mod context;
mod corrupted;
mod described;
mod disjoint;
mod file;
mod files;
pub mod given;
mod helpers;
mod helpers_header;
mod init;
pub mod interface;
mod internal;
mod layout;
mod layout_text;
mod library;
mod literal;
mod lower;
mod matrices;
mod mentions;
pub mod names;
mod near;
mod options;
pub mod outside;
mod passing;
mod placing;
mod print;
mod report;
mod reserved;
mod self_test;
mod shell;
mod signature;
mod sizes;
mod spelling;
mod status;
mod status_header;
mod target;
mod traced;
mod tree;
mod units;
mod wide;

use bessemer_ir::{Module, Span};

pub use comments::comment_text;
pub use file::{CFile, MapLine};
pub use library::Math;
pub use matrices::Layout;
pub use options::{Options, Standard};
pub use report::{EntryReport, FunctionReport, Site};
pub use reserved::is_reserved_globally as is_reserved;
pub use units::Measured;
pub use wide::Width;

use std::collections::BTreeSet;

use analysis::Faults;
use context::Context;
use given::Conflict;
use interface::Interface;
use names::Names;

/// Flags with which the emitted C compiles without warnings by gcc and clang. It requires the last one.
pub const FLAGS: &[&str] = &[
    "-std=c99",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Werror",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Wshadow",
    "-Wstrict-prototypes",
    "-Wmissing-prototypes",
    "-ffp-contract=off",
];

/// Emits a module in explicit IR; files are in the order of their names.
pub fn emit(module: &Module, options: &Options) -> Vec<CFile> {
    Plan::new(module, options).emit()
}

/// Decisions about a module in explicit IR, before anything is written: every name and place, and the functions that
/// can fault.
pub struct Plan<'m> {
    module: &'m Module,
    options: &'m Options,
    faults: Faults,
    names: Names,
}

impl<'m> Plan<'m> {
    /// Computes the decisions.
    pub fn new(module: &'m Module, options: &'m Options) -> Plan<'m> {
        let faults = Faults::new(module, options.hook.is_some());
        let names = Names::with_faults(module, options, &faults);
        Plan { module, options, faults, names }
    }

    fn context(&self) -> Context<'_> {
        Context { module: self.module, names: &self.names, faults: &self.faults }
    }

    /// Returns the names that conflict, each with its place.
    pub fn conflicts(&self) -> Vec<Conflict> {
        given::conflicts(self.module, &self.names)
    }

    /// Returns the functions whose external names are equal for some linkers, each with the earlier name.
    pub fn alike(&self) -> Vec<(Span, String, String)> {
        given::alike(self.module, &self.names)
    }

    /// Returns the files, in the order of their names.
    pub fn emit(&self) -> Vec<CFile> {
        files::files(self.context(), self.options)
    }

    /// Returns the interface of the module as data.
    pub fn interface(&self) -> Interface {
        interface::interface(self.context())
    }

    /// Reports on every entry point, in the order of the module.
    pub fn report(&self, files: &[CFile]) -> (Vec<EntryReport>, Vec<FunctionReport>) {
        report::report(self.context(), self.options, files)
    }

    /// Returns the C names of the `math.h` functions that the C calls instead of the DSL's.
    pub fn library_calls(&self) -> Vec<String> {
        let reached = files::reached(self.context());
        let mut called = BTreeSet::new();
        for (signature, _) in self.names.functions.iter().zip(reached).filter(|(_, it)| *it) {
            called.extend(signature.parts.iter().map(|name| (*name).to_owned()));
            let is_theirs = signature.storage == names::Storage::Library;
            called.extend(is_theirs.then(|| signature.name.clone()));
        }
        called.into_iter().collect()
    }
}
