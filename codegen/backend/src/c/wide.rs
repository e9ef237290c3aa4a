//! Operations that small processors do not have: in double precision, and of 64 bits.

use bessemer_ir::Span;

/// Width that an operation exceeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Width {
    /// Wider than a floating-point unit for `float` only.
    Double,
    /// Wider than registers of 32 bits.
    Long,
}

/// An operation that a small processor performs in software, or by several instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Wide {
    /// Width that it exceeds.
    pub width: Width,
    /// Span of the node.
    pub span: Span,
}
