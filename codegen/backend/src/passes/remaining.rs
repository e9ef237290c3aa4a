//! Checks that are left, and those whose proof is not believed.

use std::collections::HashSet;

use bessemer_ir::{Fault, Span};

/// A check that is left, because the operation could not be proved not to fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remaining {
    /// The fault that it reports.
    pub fault: Fault,
    /// Span of the operation.
    pub span: Span,
    /// Why it could not be proved, in words.
    pub reason: String,
}

/// Source spans of operations of which [`proof`](super::proof) does not confirm one: the checks of all of them stand.
pub(super) type Doubted = HashSet<Span>;
