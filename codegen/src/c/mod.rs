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

use bessemer_ir::Module;

pub use file::{CFile, MapLine};
pub use interface::interface;
pub use library::Math;
pub use matrices::Layout;
pub use options::{Options, Standard};
pub use print::comment_text;
pub use report::{EntryReport, Site, report};
pub use reserved::is_reserved_globally as is_reserved;
pub use units::Measured;
pub use wide::Width;

use analysis::Faults;
use context::Context;
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
    let faults = Faults::new(module, options.hook.is_some());
    let names = Names::with_faults(module, options, &faults);
    files::files(Context { module, names: &names, faults: &faults }, options)
}

/// The functions of the target's `math.h` that the C calls in place of the DSL's, by their C names.
pub fn library_calls(module: &Module, options: &Options) -> Vec<String> {
    let faults = Faults::new(module, options.hook.is_some());
    let names = Names::with_faults(module, options, &faults);
    let reached = files::reached(Context { module, names: &names, faults: &faults });
    let mut called: Vec<String> = (names.functions.iter().zip(reached))
        .filter(|(signature, reached)| *reached && signature.storage == names::Storage::Library)
        .map(|(signature, _)| signature.name.clone())
        .collect();
    called.sort();
    called
}
