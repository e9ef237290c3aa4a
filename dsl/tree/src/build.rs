//! Constructors of expressions that no author wrote, for desugaring.

use alloc::boxed::Box;

use super::{Block, Expr, ExprKind, NO_SLOT, Pattern, Site, Source, Stmt};

impl Expr {
    /// Returns an expression whose type follows from its operands.
    pub fn plain(kind: ExprKind, site: Site) -> Expr {
        Expr { kind, site, slot: None }
    }

    /// Builds the expression of a name.
    pub fn local(name: &str, site: Site) -> Expr {
        Expr::plain(ExprKind::Local(name.into()), site)
    }
}

impl ExprKind {
    /// Returns a loop over a source.
    pub fn each(pattern: Pattern, source: Source, pass: Expr) -> ExprKind {
        let (pattern, source) = (Box::new(pattern), Box::new(source));
        let body = Block { stmts: alloc::vec![Stmt::Expr(pass)], tail: None };
        ExprKind::Each { label: None, pattern, source, bound: None, body }
    }
}

impl Pattern {
    /// Returns a pattern that binds a generated name.
    pub fn name(name: &str) -> Pattern {
        Pattern::Name { name: name.into(), slot: NO_SLOT, mutable: false, inner: None }
    }
}
