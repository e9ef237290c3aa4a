//! Operations that are too wide for a small processor: in double precision, and of 64 bits.

use bessemer_ir::Span;

/// Width that an operation exceeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Width {
    /// A unit for `float` alone.
    Double,
    /// Registers of 32 bits.
    Long,
}

/// An operation that a small processor carries out in software, or in several instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Wide {
    /// Width that it exceeds.
    pub width: Width,
    /// Span of the node.
    pub span: Span,
}
