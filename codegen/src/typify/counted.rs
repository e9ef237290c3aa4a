//! Loops that count from 0.

use bessemer_ir::{Block, Expr, LocalId, Place, Span, StmtKind, Type};

/// The value of a counter.
pub(super) fn local(root: LocalId, span: Span) -> Expr {
    Place::local(root, Type::USIZE, span).load()
}

/// A loop that counts from 0.
pub(super) fn counted(variable: LocalId, count: u32, body: Block, span: Span) -> StmtKind {
    StmtKind::For {
        variable,
        from: Expr::usize(0, span),
        to: Expr::usize(u64::from(count), span),
        inclusive: false,
        reversed: false,
        unroll: None,
        ended: false,
        body,
    }
}
