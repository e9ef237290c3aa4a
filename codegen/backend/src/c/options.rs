//! User's options for the C.

use super::library::Math;
use super::matrices::Layout;
use crate::kernels::Tuning;
use crate::kernels::replace::Replacement;

/// C standard of the project.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Standard {
    /// Standard of 1999, which every compiler has.
    #[default]
    C99,
    /// Standard of 2011.
    C11,
    /// Standard of 2017.
    C17,
    /// Standard of 2024.
    C23,
    /// Standard of 1999 with GNU's extensions enabled: the C uses none.
    Gnu99,
    /// Standard of 2011 with GNU's extensions enabled.
    Gnu11,
    /// Standard of 2017 with GNU's extensions enabled.
    Gnu17,
    /// Standard of 2024 with GNU's extensions enabled.
    Gnu23,
}

impl Standard {
    /// All standards.
    pub const ALL: [Standard; 8] = [
        Standard::C99,
        Standard::C11,
        Standard::C17,
        Standard::C23,
        Standard::Gnu99,
        Standard::Gnu11,
        Standard::Gnu17,
        Standard::Gnu23,
    ];

    /// Returns the flag of gcc and clang. For C23 it is the name that older versions know, too.
    pub fn flag(self) -> &'static str {
        self.flags()[0]
    }

    /// Returns all equivalent flags.
    pub fn flags(self) -> &'static [&'static str] {
        match self {
            Standard::C99 => &["-std=c99"],
            Standard::C11 => &["-std=c11"],
            Standard::C17 => &["-std=c17"],
            Standard::C23 => &["-std=c2x"],
            Standard::Gnu99 => &["-std=gnu99"],
            Standard::Gnu11 => &["-std=gnu11"],
            Standard::Gnu17 => &["-std=gnu17"],
            Standard::Gnu23 => &["-std=gnu2x"],
        }
    }

    /// Returns the ISO name, such as `C11`.
    pub fn iso(self) -> &'static str {
        self.demand().map_or("C99", |(_, name)| name)
    }

    /// Returns the condition on `__STDC_VERSION__` for an older standard, and the standard's name; none for C99, the
    /// oldest.
    pub(super) fn demand(self) -> Option<(&'static str, &'static str)> {
        match self {
            Standard::C99 | Standard::Gnu99 => None,
            Standard::C11 | Standard::Gnu11 => Some(("__STDC_VERSION__ < 201112L", "C11")),
            Standard::C17 | Standard::Gnu17 => Some(("__STDC_VERSION__ < 201710L", "C17")),
            // Compilers from before it was published count up to it.
            Standard::C23 | Standard::Gnu23 => Some(("__STDC_VERSION__ <= 201710L", "C23")),
        }
    }
}

/// Options of the C that the user selects.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Prefix of the names of all types, functions, files and include guards.
    pub prefix: String,
    /// Folder of the headers, relative to the sources: `acme` gives `#include "acme/motor.h"`. Empty: beside the
    /// sources.
    pub headers: String,
    /// Stem of the status type: `bessemer` gives `bessemer_status_t`.
    pub status: String,
    /// Function of the firmware that a fault calls, and that does not return. With it, functions return their results
    /// and no status.
    pub hook: Option<String>,
    /// SPDX licence expression of the emitted files.
    pub license: String,
    /// C standard.
    pub standard: Standard,
    /// User's functions that replace kernels.
    pub replacements: Vec<Replacement>,
    /// Variants of the kernels.
    pub kernels: Tuning,
    /// Number of POSIX threads for a large kernel, unless `BESSEMER_THREADS` is set; 0 or 1 means none. The text of
    /// kernels does not depend on it.
    pub threads: u32,
    /// Source of the elementary functions.
    pub math: Math,
    /// Layout of matrices in memory.
    pub layout: Layout,
    /// True to emit `bessemer_self_test`, which checks the arithmetic on the target.
    pub self_test: bool,
    /// True if files have pragmas, which keep compilers from changing floating-point operations.
    pub pragmas: bool,
    /// True if files have no character beyond ASCII.
    pub ascii: bool,
    /// True if each line has a comment with its line of Rust.
    pub trace_comments: bool,
    /// True if functions and loops have contracts in ACSL.
    pub contracts: bool,
    /// True if proved checks stay in the C and end the program when one fails. This tests the compiler and is not for a
    /// target.
    pub keep_checks: bool,
}

impl Options {
    /// Returns the path by which a header is included: `motor.h`, or `acme/motor.h`.
    pub fn header(&self, stem: &str) -> String {
        match self.headers.as_str() {
            "" => format!("{stem}.h"),
            folder => format!("{folder}/{stem}.h"),
        }
    }
}

impl Default for Options {
    fn default() -> Options {
        Options {
            prefix: String::new(),
            headers: String::new(),
            status: "bessemer".to_owned(),
            hook: None,
            license: "MIT OR Apache-2.0".to_owned(),
            standard: Standard::default(),
            replacements: Vec::new(),
            kernels: Tuning::default(),
            threads: 0,
            math: Math::Portable,
            layout: Layout::Columns,
            self_test: false,
            pragmas: true,
            ascii: false,
            trace_comments: false,
            contracts: false,
            keep_checks: false,
        }
    }
}
