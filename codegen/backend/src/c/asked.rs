//! Attributes of compilers that C99 does not have: sections, inlining, copies without a call, unrolling.
//!
//! Each is a macro that is empty for an unknown compiler, defined in the file that uses it. Firmware for another
//! compiler can define it on the command line.

use bessemer_ir::{Attributes, Inlining};

use super::options::Options;
use super::spelling::identifier;

/// A macro for a compiler attribute.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Macro {
    AlwaysInline,
    Copy,
    NeverInline,
    Section,
    Unroll,
}

impl Macro {
    /// Returns its name in C.
    pub fn name(self, options: &Options) -> String {
        let stem = identifier(&options.status).to_uppercase();
        match self {
            Macro::AlwaysInline => format!("{stem}_ALWAYS_INLINE"),
            Macro::Copy => format!("{stem}_COPY"),
            Macro::NeverInline => format!("{stem}_NEVER_INLINE"),
            Macro::Section => format!("{stem}_SECTION"),
            Macro::Unroll => format!("{stem}_UNROLL"),
        }
    }

    /// Returns its definition in C.
    pub fn text(self, options: &Options) -> String {
        let (name, docs) = (self.name(options), self.docs());
        let (parameters, meaning) = match self {
            Macro::AlwaysInline => ("", "always_inline"),
            Macro::NeverInline => ("", "noinline"),
            Macro::Section => ("(name)", "section(name)"),
            Macro::Copy => return copy(&name, docs),
            Macro::Unroll if options.pragmas => return unroll(&name, docs),
            Macro::Unroll => {
                return format!("/* {docs} Nothing without pragmas. */\n#define {name}(count)");
            }
        };
        format!(
            "/* {docs} Nothing where the compiler is not known. */\n#ifndef {name}\n#if defined(__GNUC__)\n\
             #define {name}{parameters} __attribute__(({meaning}))\n#else\n#define {name}{parameters}\n\
             #endif\n#endif"
        )
    }

    fn docs(self) -> &'static str {
        match self {
            Macro::AlwaysInline => "Stands where it is called.",
            Macro::Copy => {
                "memcpy, and no call of it even where the library is unknown (-ffreestanding, -fno-builtin)."
            }
            Macro::NeverInline => "Stands by itself, however often it is called.",
            Macro::Section => "Stands in a section of its own.",
            Macro::Unroll => {
                "So many passes of the loop are written out at once; 1 keeps the loop."
            }
        }
    }
}

/// Returns the macros that a function's author requests, each with its text in front of the function.
pub fn of(attributes: &Attributes, options: &Options) -> Vec<(Macro, String)> {
    let mut asked: Vec<_> =
        attributes.section.iter().map(|name| (Macro::Section, section(name, options))).collect();
    match attributes.inlining {
        Inlining::Free => {}
        Inlining::Never => {
            asked.push((Macro::NeverInline, Macro::NeverInline.name(options)));
        }
        Inlining::Always => {
            asked.push((Macro::AlwaysInline, Macro::AlwaysInline.name(options)));
        }
    }
    asked
}

/// Returns the text in front of a function or a constant that places it in a section.
pub fn section(section: &str, options: &Options) -> String {
    format!("{}(\"{section}\")", Macro::Section.name(options))
}

/// Defines a name for `memcpy` that compilers expand inline, also with `-ffreestanding`.
fn copy(name: &str, docs: &str) -> String {
    format!(
        "/* {docs} */\n#ifndef {name}\n#if defined(__GNUC__)\n#define {name} __builtin_memcpy\n#else\n\
         #define {name} memcpy\n#endif\n#endif"
    )
}

/// Defines the macro in front of a loop that requests unrolling, by the pragma of each compiler.
fn unroll(name: &str, docs: &str) -> String {
    let pragma = name.replace("_UNROLL", "_PRAGMA");
    let define = |word: &str| {
        format!(
            "#define {pragma}(text) _Pragma(#text)\n#define {name}(count) {pragma}({word} count)\n"
        )
    };
    format!(
        "/* {docs} Nothing where the compiler is not known. */\n#ifndef {name}\n#if defined(__clang__)\n{}\
         #elif defined(__GNUC__) && __GNUC__ >= 8\n{}#else\n#define {name}(count)\n#endif\n#endif",
        define("unroll"),
        define("GCC unroll")
    )
}
