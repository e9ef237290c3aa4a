//! Sites of nodes, and names that builder and witness copy share.

use std::cell::Cell;

pub use bessemer_tree::Site;
use bessemer_tree::{Expr, ExprKind};
use quote::format_ident;
use syn::ext::IdentExt;
use syn::spanned::Spanned;

/// Rust's name of the receiver.
pub(super) const SELF: &str = "self";

thread_local! {
    static GENERATING: Cell<bool> = const { Cell::new(false) };
}

/// Returns true if the expanded attribute belongs to a generation build. In any other build the walk only refuses:
/// positions need a call into rustc each, and nobody reads the witness copy.
pub fn generating() -> bool {
    GENERATING.get()
}

/// Runs an expansion of a generation build.
pub fn in_generation<T>(expand: impl FnOnce() -> T) -> T {
    GENERATING.set(true);
    let expanded = expand();
    GENERATING.set(false);
    expanded
}

/// Returns line and column of a node, both from 1; unknown outside a generation build.
pub fn site(node: &impl Spanned) -> Site {
    if !generating() {
        return Site::default();
    }
    let start = node.span().start();
    Site(start.line as u32, start.column as u32 + 1)
}

/// Expression that replaces a refused one.
pub(super) const UNIT: ExprKind = ExprKind::Tuple(Vec::new());

/// Returns an expression of the tree without a slot.
pub(super) fn plain(kind: ExprKind, node: &impl Spanned) -> Expr {
    Expr::plain(kind, site(node))
}

/// Returns the site of an expression.
pub fn place(expr: &syn::Expr) -> Site {
    if generating() { site(&span(expr)) } else { Site::default() }
}

/// Returns the span of an expression's first token. syn would find it by printing the whole expression, once for each
/// level of nesting.
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

/// Returns a name as text, without the `r#` of a raw one.
pub fn text(ident: &syn::Ident) -> String {
    ident.unraw().to_string()
}

/// Returns the name of a slot in the builder.
pub fn slot_name(slot: u32) -> syn::Ident {
    format_ident!("__s{slot}")
}

/// Returns the name of a callee's slot in the builder.
pub fn callee_name(callee: u32) -> syn::Ident {
    format_ident!("__c{callee}")
}

/// Returns the name of the slot for an author's function behind an operator.
pub fn own_name(operator: usize) -> syn::Ident {
    format_ident!("__o{operator}")
}
