//! The demands of every source on its compiler and on the processor: a header of its own, which each of them includes.
//!
//! It refuses what would compute other bits and takes back what a compiler does to floats unasked. Its text is in
//! `codegen/backend/templates/`, and depends on names and on what the user decided about the build alone. A header that computes says
//! the same for its own lines instead: what includes it may be anybody's. So it demands no standard, either: a header is
//! C99 and C++, whatever its sources are compiled as.

use std::fmt::Write as _;

use super::context::Context;
use super::file::CFile;
use super::options::Options;
use super::shell::{Shell, whole};
use super::spelling::identifier;

/// The header's name.
pub fn name(options: &Options) -> String {
    options.header(&format!("{}_target", identifier(&options.status)))
}

/// The demand for the standard that the user decided for, what it has to check sizes with, and the number of threads.
fn decided(options: &Options) -> String {
    let mut text = String::new();
    if let Some((older, name)) = options.standard.demand() {
        let flag = options.standard.flag();
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "#include <limits.h>\n\n#if {older}\n#error \"this is {name}: compile it with {flag}, or with a later standard\"\n#endif\n\
             _Static_assert(CHAR_BIT == 8, \"a byte needs 8 bits\");\n\
             _Static_assert(sizeof(float) == 4U, \"float needs 32 bits\");\n\
             _Static_assert(sizeof(double) == 8U, \"double needs 64 bits\");\n"
        );
    }
    if options.threads > 1 {
        let _ = write!(
            text,
            "\n/* How many threads share the work of a large kernel. */\n#if !defined(BESSEMER_THREADS)\n\
             #define BESSEMER_THREADS {}U\n#endif\n",
            options.threads
        );
    }
    text
}

/// The header.
pub fn header(context: Context<'_>, options: &Options) -> CFile {
    let name = name(options);
    let shell = Shell {
        about: &[],
        file: &name,
        header: &name,
        summary: "what the C needs of compiler and processor.",
        source: &context.module.name,
        license: &options.license,
        system_includes: Vec::new(),
        own_includes: Vec::new(),
        calls: false,
        refuses: true,
        computes: false,
    };
    let text = whole(&shell, include_str!("../../templates/target.h.tera"), &decided(options));
    CFile { name, text, map: Vec::new() }
}
