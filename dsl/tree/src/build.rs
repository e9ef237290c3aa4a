//! Expressions of the tree that no author wrote, made of their parts: what is desugared, and what the compiler puts beside it.

use alloc::vec::Vec;

use super::{Block, Expr, ExprKind, NO_SLOT, Order, Part, Pattern, Site, Stmt};

impl Expr {
    /// An expression whose type follows from its parts.
    pub fn plain(kind: ExprKind, site: Site) -> Expr {
        Expr { kind, site, slot: None }
    }

    /// What a name means.
    pub fn local(name: &str, site: Site) -> Expr {
        Expr::plain(ExprKind::Local(name.into()), site)
    }
}

impl ExprKind {
    /// A loop through all elements from the first on, each with its index if that has a name.
    pub fn each(index: Option<&str>, part: Part, pass: Expr) -> ExprKind {
        let (index, parts) = (index.map(Into::into), alloc::vec![part]);
        let body = Block { stmts: alloc::vec![Stmt::Expr(pass)], tail: None };
        ExprKind::Each { label: None, index, parts, order: Order::Up, cuts: Vec::new(), body }
    }
}

impl Pattern {
    /// A name that no author gave.
    pub fn name(name: &str) -> Pattern {
        Pattern::Name { name: name.into(), slot: NO_SLOT, mutable: false, inner: None }
    }
}
