//! Requests to compilers for which C99 has no word: sections, inlining, copies without a call.
//!
//! Each is a macro that is empty where the compiler knows no such attribute, defined in the file that uses
//! it; a firmware for another compiler defines it on the command line.

use bessemer_ir::{Attributes, Inlining};

use super::options::Options;
use super::spelling::identifier;

/// One of the macros.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Macro {
    AlwaysInline,
    Copy,
    NeverInline,
    Section,
    Unroll,
}

impl Macro {
    /// Its name.
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

    /// The text that defines it.
    pub fn text(self, options: &Options) -> String {
        let (name, docs) = (self.name(options), self.docs());
        let (parameters, meaning) = match self {
            Macro::AlwaysInline => ("", "always_inline"),
            Macro::NeverInline => ("", "noinline"),
            Macro::Section => ("(name)", "section(name)"),
            Macro::Copy => return copy(&name, docs),
            Macro::Unroll => return unroll(&name, docs),
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

/// The macros that a function's author requests, each as it precedes the function.
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

/// The section of a function or a constant, as it precedes it.
pub fn section(section: &str, options: &Options) -> String {
    format!("{}(\"{section}\")", Macro::Section.name(options))
}

/// The name of memcpy by which the compiler knows it, whatever it is reported the library.
fn copy(name: &str, docs: &str) -> String {
    format!(
        "/* {docs} */\n#ifndef {name}\n#if defined(__GNUC__)\n#define {name} __builtin_memcpy\n#else\n\
         #define {name} memcpy\n#endif\n#endif"
    )
}

/// The macro before a loop, which is a pragma, and another for each compiler.
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
