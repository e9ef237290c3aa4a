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
mod const_names;
mod files;
pub mod given;
mod helpers;
mod init;
mod layout;
mod layout_text;
mod library;
mod literal;
mod lower;
mod matrices;
pub mod names;
mod passing;
mod placing;
mod print;
mod report;
mod reserved;
mod self_test;
mod shell;
mod spelling;
mod status;
mod target;
mod tree;
mod units;

use bessemer_ir::Module;

pub use library::Math;
pub use matrices::Layout;
pub use report::{EntryReport, report};
pub use units::Measured;

use analysis::Faults;
use names::Names;

use crate::kernels::Tuning;
use crate::kernels::replace::Replacement;

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

/// What the user decides about the C.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Stands before the name of every type and function.
    pub prefix: String,
    /// The stem of the status type: `bessemer` gives `bessemer_status_t`.
    pub status: String,
    /// A function of the firmware's that a fault calls, and that does not return: then functions return
    /// their results plainly, and no status.
    pub hook: Option<String>,
    /// The SPDX expression of the emitted files.
    pub license: String,
    /// The user's own functions in place of kernels.
    pub replacements: Vec<Replacement>,
    /// How kernels are made.
    pub kernels: Tuning,
    /// Whose elementary functions are called.
    pub math: Math,
    /// How matrices lie in memory.
    pub layout: Layout,
    /// Whether `bessemer_self_test` comes along, which tells on the target whether its arithmetic is as the C needs it.
    pub self_test: bool,
    /// Whether checks that were proved stand in the C all the same, and end the program where one fails: to test the
    /// compiler with, not for a target.
    pub keep_checks: bool,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            prefix: String::new(),
            status: "bessemer".to_owned(),
            hook: None,
            license: "MIT OR Apache-2.0".to_owned(),
            replacements: Vec::new(),
            kernels: Tuning::default(),
            math: Math::Portable,
            layout: Layout::Columns,
            self_test: false,
            keep_checks: false,
        }
    }
}

/// An emitted file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CFile {
    /// `height.h`.
    pub name: String,
    /// What is in it.
    pub text: String,
    /// Where its lines come from, in order.
    pub map: Vec<MapLine>,
}

/// A line of C and the line of Rust that it comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MapLine {
    /// Line of the C file, from 1.
    pub c_line: u32,
    /// The Rust file, relative to the workspace.
    pub rust_file: String,
    /// Line of the Rust file, from 1.
    pub rust_line: u32,
    /// The Rust path of the function, empty for a type.
    pub function: String,
}

/// Emits a module that the passes have made explicit; files in the order of their names.
pub fn emit(module: &Module, options: &Options) -> Vec<CFile> {
    let faults = Faults::new(module, options.hook.is_some());
    let names = Names::with_faults(module, options, &faults);
    files::files(lower::Context { module, names: &names, faults: &faults }, options)
}

/// The functions of the target's `math.h` that the C calls in place of the DSL's, by their C names.
pub fn library_calls(module: &Module, options: &Options) -> Vec<String> {
    let faults = Faults::new(module, options.hook.is_some());
    let names = Names::with_faults(module, options, &faults);
    let reached = files::reached(lower::Context { module, names: &names, faults: &faults });
    let mut called: Vec<String> = (names.functions.iter().zip(reached))
        .filter(|(signature, reached)| *reached && signature.storage == names::Storage::Library)
        .map(|(signature, _)| signature.name.clone())
        .collect();
    called.sort();
    called
}
