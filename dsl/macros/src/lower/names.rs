//! Sites and names of nodes, and the names shared by builder and witness copy.

use std::cell::Cell;

pub use bessemer_tree::Site;
use bessemer_tree::{Expr, ExprKind};
use quote::format_ident;
use syn::ext::IdentExt;
use syn::spanned::Spanned;

thread_local! {
    static GENERATING: Cell<bool> = const { Cell::new(false) };
}

/// The attribute that is being expanded is of a generation build. In any other build the walk only refuses: places cost a
/// call into rustc each, and nobody reads the witness copy.
pub fn generating() -> bool {
    GENERATING.get()
}

/// Expands what is of a generation build.
pub fn in_generation<T>(expand: impl FnOnce() -> T) -> T {
    GENERATING.set(true);
    let expanded = expand();
    GENERATING.set(false);
    expanded
}

/// Line and column of a node, both from 1; unknown outside a generation build.
pub fn site(node: &impl Spanned) -> Site {
    if !generating() {
        return Site::default();
    }
    let start = node.span().start();
    Site(start.line as u32, start.column as u32 + 1)
}

/// The stand-in for an expression that was refused.
pub(super) const UNIT: ExprKind = ExprKind::Tuple(Vec::new());

/// An expression of the tree that rustc is not asked about.
pub(super) fn plain(kind: ExprKind, node: &impl Spanned) -> Expr {
    Expr::plain(kind, site(node))
}

/// The site of an expression.
pub fn place(expr: &syn::Expr) -> Site {
    if generating() { site(&span(expr)) } else { Site::default() }
}

/// The span of an expression: that of its first token. Syn finds it by printing the whole, and what nests as deep as an
/// author's expressions would be printed once for each level.
pub fn span(expr: &syn::Expr) -> proc_macro2::Span {
    match expr {
        syn::Expr::Binary(it) if it.attrs.is_empty() => span(&it.left),
        syn::Expr::MethodCall(it) if it.attrs.is_empty() => span(&it.receiver),
        syn::Expr::Field(it) if it.attrs.is_empty() => span(&it.base),
        syn::Expr::Index(it) if it.attrs.is_empty() => span(&it.expr),
        syn::Expr::Cast(it) if it.attrs.is_empty() => span(&it.expr),
        syn::Expr::Try(it) if it.attrs.is_empty() => span(&it.expr),
        syn::Expr::Call(it) if it.attrs.is_empty() => span(&it.func),
        syn::Expr::If(it) if it.attrs.is_empty() => it.if_token.span,
        syn::Expr::Unary(it) if it.attrs.is_empty() => it.op.span(),
        syn::Expr::Paren(it) if it.attrs.is_empty() => it.paren_token.span.open(),
        syn::Expr::Block(it) if it.attrs.is_empty() && it.label.is_none() => {
            it.block.brace_token.span.open()
        }
        other => other.span(),
    }
}

/// A name as it travels: without the `r#` of a raw one.
pub fn text(ident: &syn::Ident) -> String {
    ident.unraw().to_string()
}

/// The name of a slot in the builder.
pub fn slot_name(slot: u32) -> syn::Ident {
    format_ident!("__s{slot}")
}

/// The name of a callee's slot in the builder.
pub fn callee_name(callee: u32) -> syn::Ident {
    format_ident!("__c{callee}")
}

/// The name of the slot of the author's own function behind an operator.
pub fn own_name(operator: usize) -> syn::Ident {
    format_ident!("__o{operator}")
}
