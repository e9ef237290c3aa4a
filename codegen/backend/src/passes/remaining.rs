//! Remaining checks, and operations whose proof is doubted.

use std::collections::HashSet;

use bessemer_ir::{Fault, Span};

/// A check that remains, since the operation was not proved not to fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remaining {
    /// The fault that it reports.
    pub fault: Fault,
    /// Span of the operation.
    pub span: Span,
    /// Text that says why it could not be proved.
    pub reason: String,
}

/// Spans of operations that the analysis proved and [`proof`](super::proof) does not confirm; all their checks are
/// kept.
pub(super) type Doubted = HashSet<Span>;
