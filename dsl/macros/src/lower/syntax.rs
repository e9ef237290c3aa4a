//! Properties of expressions that their syntax shows.

use quote::{ToTokens, quote};

use super::names::text;

pub(super) fn bare(expr: &syn::Expr) -> &syn::Expr {
    match expr {
        syn::Expr::Paren(it) => bare(&it.expr),
        syn::Expr::Group(it) => bare(&it.expr),
        syn::Expr::Block(it) if it.label.is_none() => match it.block.stmts.as_slice() {
            [syn::Stmt::Expr(only, None)] => bare(only),
            _ => expr,
        },
        other => other,
    }
}

/// Returns true if an expression may be evaluated twice, or not at all: a number, a name, a part of one.
pub(super) fn is_plain(expr: &syn::Expr) -> bool {
    match bare(expr) {
        syn::Expr::Lit(_) | syn::Expr::Path(_) => true,
        syn::Expr::Field(it) => is_plain(&it.base),
        syn::Expr::Reference(it) => is_plain(&it.expr),
        syn::Expr::Unary(it) => match it.op {
            syn::UnOp::Neg(_) => matches!(bare(&it.expr), syn::Expr::Lit(_)),
            syn::UnOp::Deref(_) => is_plain(&it.expr),
            _ => false,
        },
        _ => false,
    }
}

/// Returns true if an expression contains a name; may be true for an unrelated use of the same word.
pub(super) fn names(expr: &impl ToTokens, name: &str) -> bool {
    times_named(expr, name) > 0
}

/// Returns the number of occurrences of a name (without `r#`) in an expression, in any role.
pub(super) fn times_named(expr: &impl ToTokens, name: &str) -> usize {
    fn count(tokens: proc_macro2::TokenStream, name: &str) -> usize {
        let of = |token| match token {
            proc_macro2::TokenTree::Ident(ident) => usize::from(text(&ident) == name),
            proc_macro2::TokenTree::Group(group) => count(group.stream(), name),
            _ => 0,
        };
        tokens.into_iter().map(of).sum()
    }
    count(quote! { #expr }, name)
}

/// Returns a free name that begins with `name`.
pub(super) fn fresh(name: &str, is_taken: impl Fn(&str) -> bool) -> syn::Ident {
    let mut fresh = name.to_owned();
    while is_taken(&fresh) {
        fresh.push('_');
    }
    syn::Ident::new(&fresh, proc_macro2::Span::call_site())
}

/// Returns true if a path denotes a variant.
pub(super) fn is_variant(path: &syn::Path) -> bool {
    path.segments.len() > 1 && is_constructor_name(&last_segment(path))
}

/// Returns true if a path is a constant of a type that may be generic: its arguments follow only from its use.
pub(super) fn is_of_type(path: &syn::Path) -> bool {
    let owner = path.segments.iter().rev().nth(1);
    owner.is_some_and(|it| {
        it.ident != "Self" && it.arguments.is_none() && is_constructor_name(&text(&it.ident))
    })
}

/// Returns true if a name looks like a variant or a struct: it has a capital and small letters.
pub(super) fn is_constructor_name(name: &str) -> bool {
    name.trim_start_matches('_')
        .starts_with(|first: char| first.is_uppercase() || first.is_numeric())
        && name.contains(|letter: char| letter.is_lowercase())
}

/// Returns the name of a type without its modules.
pub fn last_ident(ty: &syn::Type) -> Option<&syn::Ident> {
    match ty {
        syn::Type::Path(it) => it.path.segments.last().map(|segment| &segment.ident),
        _ => None,
    }
}

/// Returns the last name of a path.
pub(super) fn last_segment(path: &syn::Path) -> String {
    path.segments.last().map(|segment| text(&segment.ident)).unwrap_or_default()
}
