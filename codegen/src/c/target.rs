//! The demands of every source on its compiler and on the processor: a header of its own, which each of them includes.
//!
//! It refuses what would compute other bits and takes back what a compiler does to floats unasked. Its text is in
//! `codegen/templates/`, and depends on names alone. A header that computes says the same for its own lines instead:
//! what includes it may be anybody's.

use super::context::Context;
use super::file::CFile;
use super::options::Options;
use super::shell::{Shell, whole};
use super::spelling::identifier;

/// The header's name.
pub fn name(options: &Options) -> String {
    format!("{}_target.h", identifier(&options.status))
}

/// The header.
pub fn header(context: Context<'_>, options: &Options) -> CFile {
    let name = name(options);
    let shell = Shell {
        file: &name,
        header: &name,
        summary: "what the C needs of compiler and processor.",
        source: &context.module.name,
        license: &options.license,
        system_includes: Vec::new(),
        own_includes: Vec::new(),
        calls: false,
        refuses: true,
    };
    let text = whole(&shell, include_str!("../../templates/target.h.tera"));
    CFile { name, text, map: Vec::new() }
}
