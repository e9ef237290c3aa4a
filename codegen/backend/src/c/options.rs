//! The user's decisions about the C.

use super::library::Math;
use super::matrices::Layout;
use crate::kernels::Tuning;
use crate::kernels::replace::Replacement;

/// The standard of C that the project is compiled by.
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
    /// Each of them.
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

    /// The flag that asks gcc and clang for it: that of 2024 by the name that older ones know, too.
    pub fn flag(self) -> &'static str {
        self.flags()[0]
    }

    /// Returns the flags as a list.
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

    /// The name of ISO's own: `C11`.
    pub fn iso(self) -> &'static str {
        self.demand().map_or("C99", |(_, name)| name)
    }

    /// The condition on `__STDC_VERSION__` that refuses an older compilation, and the standard's name; none for the oldest, which has
    /// nothing that another lacks.
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
    /// Stands before the name of every type, function and file, and so of every include guard.
    pub prefix: String,
    /// The folder of the headers, below that of the sources: `acme` gives `#include "acme/motor.h"`. Empty: beside the sources.
    pub headers: String,
    /// The stem of the status type: `bessemer` gives `bessemer_status_t`.
    pub status: String,
    /// A function of the firmware's that a fault calls, and that does not return: then functions return
    /// their results plainly, and no status.
    pub hook: Option<String>,
    /// The SPDX expression of the emitted files.
    pub license: String,
    /// The standard of C.
    pub standard: Standard,
    /// The user's own functions in place of kernels.
    pub replacements: Vec<Replacement>,
    /// Variants of the kernels.
    pub kernels: Tuning,
    /// Number of POSIX threads that share the work of a large kernel, unless `BESSEMER_THREADS` is set; up to 1, none.
    /// The text of no kernel depends on it.
    pub threads: u32,
    /// Whose elementary functions are called.
    pub math: Math,
    /// Layout of matrices in memory.
    pub layout: Layout,
    /// True if `bessemer_self_test` comes along, which tells on the target whether its arithmetic is as the C needs it.
    pub self_test: bool,
    /// True if proved checks stay in the C and end the program when one fails. This tests the compiler and is not for a
    /// target.
    pub keep_checks: bool,
}

impl Options {
    /// The name of a header, as it is included: `motor.h`, or `acme/motor.h`.
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
            keep_checks: false,
        }
    }
}
