//! Names of the headers that only sources include.

use super::options::Options;
use super::spelling::identifier;

/// Returns the name of the header of inline functions.
pub fn inline(options: &Options) -> String {
    named(options, "inline")
}

/// Returns the name of the header of constants.
pub fn constants(options: &Options) -> String {
    named(options, "constants")
}

fn named(options: &Options, what: &str) -> String {
    options.header(&format!("{}_{what}", identifier(&options.status)))
}
