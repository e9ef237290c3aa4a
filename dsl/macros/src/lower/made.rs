//! Expressions of the tree that no author wrote.

use bessemer_ir::tree::{self, ExprKind};
use syn::spanned::Spanned;

use super::names::site;

/// The stand-in for an expression that was refused.
pub(super) const UNIT: ExprKind = ExprKind::Tuple(Vec::new());

/// An expression of the tree that rustc is not asked about.
pub(super) fn plain(kind: ExprKind, node: &impl Spanned) -> tree::Expr {
    tree::Expr { kind, site: site(node), slot: None }
}
