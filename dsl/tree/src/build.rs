//! Expressions of the tree that no author wrote, made of their parts: what is desugared, and what the compiler puts beside it.

use alloc::boxed::Box;

use super::{Block, Expr, ExprKind, NO_SLOT, Pattern, Site, Source, Stmt};

impl Expr {
    /// An expression whose type follows from its parts.
    pub fn plain(kind: ExprKind, site: Site) -> Expr {
        Expr { kind, site, slot: None }
    }

    /// Builds the expression of a name.
    pub fn local(name: &str, site: Site) -> Expr {
        Expr::plain(ExprKind::Local(name.into()), site)
    }
}

impl ExprKind {
    /// A loop through a source.
    pub fn each(pattern: Pattern, source: Source, pass: Expr) -> ExprKind {
        let (pattern, source) = (Box::new(pattern), Box::new(source));
        let body = Block { stmts: alloc::vec![Stmt::Expr(pass)], tail: None };
        ExprKind::Each { label: None, pattern, source, bound: None, body }
    }
}

impl Pattern {
    /// A name that no author gave.
    pub fn name(name: &str) -> Pattern {
        Pattern::Name { name: name.into(), slot: NO_SLOT, mutable: false, inner: None }
    }
}
