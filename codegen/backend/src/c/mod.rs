//! The C back end: explicit IR in, C99 files out.
//!
//! lowering ([`lower`]) → C tree ([`tree`]) → printer ([`print`]) → file shells ([`shell`]). [`names`]
//! decides every identifier beforehand, and serves whoever has to call the emitted C.
//!
//! Invariants: the same module gives the same bytes; the text of a function depends on that function,
//! the faces of its callees, and its types; no line numbers, dates or versions in the C; no state, no
//! heap, no recursion, every loop bounded. It knows nothing of Rust's front end, and changes nothing
//! in the IR.

mod analysis;
mod asked;
mod assemble;
mod const_names;
mod context;
mod described;
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
pub mod names;
mod options;
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
mod tree;
mod units;
mod wide;

use bessemer_ir::{Module, Span};

pub use file::{CFile, MapLine};
pub use library::Math;
pub use matrices::Layout;
pub use options::{Options, Standard};
pub use print::comment_text;
pub use report::{EntryReport, Site};
pub use reserved::is_reserved_globally as is_reserved;
pub use units::Measured;
pub use wide::Width;

use analysis::Faults;
use context::Context;
use given::Taken;
use interface::Interface;
use names::Names;

/// The flags under which emitted C raises no warning, with gcc and clang; the last of them it needs.
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

/// Emits a module that the passes have made explicit; files in the order of their names.
pub fn emit(module: &Module, options: &Options) -> Vec<CFile> {
    Plan::new(module, options).emit()
}

/// All that is decided of a module before anything is written: every name and place, and who can fault. The module is one
/// that the passes have made explicit.
pub struct Plan<'m> {
    module: &'m Module,
    options: &'m Options,
    faults: Faults,
    names: Names,
}

impl<'m> Plan<'m> {
    /// Decides it.
    pub fn new(module: &'m Module, options: &'m Options) -> Plan<'m> {
        let faults = Faults::new(module, options.hook.is_some());
        let names = Names::with_faults(module, options, &faults);
        Plan { module, options, faults, names }
    }

    fn context(&self) -> Context<'_> {
        Context { module: self.module, names: &self.names, faults: &self.faults }
    }

    /// The names that cannot be given, each with its place.
    pub fn taken(&self) -> Vec<(Span, Taken)> {
        given::taken(self.module, &self.names)
    }

    /// The files, in the order of their names.
    pub fn emit(&self) -> Vec<CFile> {
        files::files(self.context(), self.options)
    }

    /// The face of the module.
    pub fn interface(&self) -> Interface {
        interface::interface(self.context())
    }

    /// Reports on every entry point, in the order of the module.
    pub fn report(&self, files: &[CFile]) -> Vec<EntryReport> {
        report::report(self.context(), self.options, files)
    }

    /// The functions of the target's `math.h` that the C calls in place of the DSL's, by their C names.
    pub fn library_calls(&self) -> Vec<String> {
        let reached = files::reached(self.context());
        let mut called: Vec<String> = (self.names.functions.iter().zip(reached))
            .filter(|(it, reached)| *reached && it.storage == names::Storage::Library)
            .map(|(it, _)| it.name.clone())
            .collect();
        called.sort();
        called
    }
}
