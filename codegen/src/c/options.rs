//! The user's decisions about the C.

use super::library::Math;
use super::matrices::Layout;
use crate::kernels::Tuning;
use crate::kernels::replace::Replacement;

/// What the user decides about the C.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Stands before the name of every type, function and file, and so of every include guard.
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
