//! An error of the author while a package is lowered, before its file is known.
//!
//! Must not know: the messages ([`refusals`](super::refusals)).

use bessemer_ir::tree::Site;
use bessemer_ir::{StructId, Type};

use super::refusals;
use crate::diagnostic::{Diagnostic, OUR_FAULT};

/// An error of the author: site, message and remedy.
pub(super) struct Problem {
    pub(super) site: Site,
    /// Message; empty if the error was reported elsewhere.
    pub(super) message: String,
    pub(super) help: String,
}

pub(super) type Result<T, E = Problem> = std::result::Result<T, E>;

pub(super) fn problem<T>(
    site: Site,
    message: impl Into<String>,
    help: impl Into<String>,
) -> Result<T> {
    Err(Problem { site, message: message.into(), help: help.into() })
}

/// Returns an error with a message of the table.
pub(super) fn refused<T>(site: Site, (message, help): refusals::Reason) -> Result<T> {
    problem(site, message, help)
}

/// Conversion of an absent value to an error.
pub(super) trait Needed<T>: Sized {
    fn or_told(self, site: Site, message: impl Into<String>, help: &str) -> Result<T>;

    /// Returns the value, or an error with a message of the table.
    fn or_refused(self, site: Site, (message, help): refusals::Reason) -> Result<T> {
        self.or_told(site, message, help)
    }

    /// Returns the value, or an internal error, since only a bug of the compiler can leave it absent.
    fn needed(self, site: Site, message: impl Into<String>) -> Result<T> {
        self.or_told(site, message, OUR_FAULT)
    }
}

impl<T> Needed<T> for Option<T> {
    fn or_told(self, site: Site, message: impl Into<String>, help: &str) -> Result<T> {
        self.map_or_else(|| problem(site, message, help), Ok)
    }
}

/// Returns the struct that a type must be.
pub(super) fn struct_of(ty: &Type, site: Site, wanted: &str) -> Result<StructId> {
    match ty {
        Type::Struct(id) => Ok(*id),
        _ => problem(site, format!("this is not {wanted}"), OUR_FAULT),
    }
}

/// Returns a problem as a diagnostic in a file.
pub(super) fn diagnostic(file: &str, problem: Problem) -> Diagnostic {
    let Problem { site: Site(line, column), message, help } = problem;
    Diagnostic { file: file.to_owned(), line, column, message, help, ..Diagnostic::default() }
}
