//! Requirements of all sources on compiler and processor, as a header that each of them includes.
//!
//! It rejects compilers that would compute other bits, and reverts their changes to floating-point operations. Its
//! text is in `codegen/backend/templates/`; it depends only on names and on the user's build options. A header with
//! computing functions has these lines itself, since any file may include it. It requires no C standard: a header is
//! both C99 and C++.

use std::fmt::Write as _;

use super::context::Context;
use super::file::CFile;
use super::options::Options;
use super::shell::{Shell, whole};
use super::spelling::identifier;
use super::status::{FEW, few};

/// Returns the header's name.
pub fn name(options: &Options) -> String {
    options.header(&format!("{}_target", identifier(&options.status)))
}

/// Returns the lines that depend on options: the required C standard, a check of sizes, and the number of threads.
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
    if let Some(few) = few(options) {
        let _ = write!(
            text,
            "\n/* Has gcc write out the few passes of the loop behind it, unless the text is to be short (-Os). */\n\
             #if !defined({few})\n#if defined(__GNUC__) && !defined(__clang__) && !defined(__INTEL_COMPILER) \\\n    \
             && (__GNUC__ > 7) && !defined(__OPTIMIZE_SIZE__)\n#define {few} _Pragma(\"GCC unroll {FEW}\")\n#else\n\
             #define {few}\n#endif\n#endif\n"
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

/// Returns the header.
pub fn header(context: Context<'_>, options: &Options) -> CFile {
    let name = name(options);
    let shell = Shell {
        about: &[],
        file: &name,
        header: &name,
        summary: "what the C needs of compiler and processor.",
        source: &context.module.name,
        license: &options.license,
        pragmas: options.pragmas,
        system_includes: Vec::new(),
        own_includes: Vec::new(),
        calls: false,
        refuses: true,
        computes: false,
    };
    let text = whole(&shell, include_str!("../../templates/target.h.tera"), &decided(options));
    CFile { name, text, map: Vec::new() }
}
