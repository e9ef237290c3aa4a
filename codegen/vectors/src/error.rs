//! Errors of an emission.

use bessemer_ir::{Function, Module, Span};

/// A function that lanes cannot compute.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}:{line}:{column}: `{function}` {what}")]
pub struct Error {
    /// File of the author, relative to the workspace.
    pub file: String,
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1.
    pub column: u32,
    /// Name of the function.
    pub function: String,
    /// Reason, and a remedy.
    pub what: String,
}

impl Error {
    pub(crate) fn new(module: &Module, function: &Function, span: Span, what: &str) -> Error {
        let file = module.files.get(span.file as usize).cloned().unwrap_or_default();
        let (line, column) = (span.line, span.column);
        Error { file, line, column, function: function.name.clone(), what: what.to_owned() }
    }
}
