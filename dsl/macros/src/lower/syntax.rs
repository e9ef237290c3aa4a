//! Properties of expressions that show by their syntax alone.

use quote::{ToTokens, quote};

use super::names::text;

/// The two sides of `a.cmp(&b)`, or of `a.partial_cmp(&b).unwrap_or(Ordering::Equal)`.
pub(super) fn compared(body: &syn::Expr) -> Option<(syn::Expr, syn::Expr)> {
    let syn::Expr::MethodCall(it) = bare(body) else { return None };
    let (call, known) = match (text(&it.method).as_str(), bare(&it.receiver)) {
        ("cmp", _) => (it, "cmp"),
        ("unwrap_or", syn::Expr::MethodCall(call))
            if it.args.to_token_stream().to_string().ends_with("Equal") =>
        {
            (call, "partial_cmp")
        }
        _ => return None,
    };
    if call.method != known || call.args.len() != 1 {
        return None;
    }
    let right = match &call.args[0] {
        syn::Expr::Reference(it) => (*it.expr).clone(),
        other => other.clone(),
    };
    Some(((*call.receiver).clone(), right))
}

/// Whether an iterator gives pairs, as far as its syntax shows.
pub(super) fn gives_pairs(expr: &syn::Expr) -> bool {
    match bare(expr) {
        syn::Expr::MethodCall(it) => match text(&it.method).as_str() {
            "enumerate" | "zip" => true,
            "rev" | "skip" | "take" | "filter" | "take_while" | "skip_while" => {
                gives_pairs(&it.receiver)
            }
            _ => false,
        },
        _ => false,
    }
}

/// Whether an iterator gives references, as far as its syntax shows.
pub(super) fn gives_references(expr: &syn::Expr) -> bool {
    match bare(expr) {
        syn::Expr::Reference(_) => true,
        syn::Expr::MethodCall(it) => match text(&it.method).as_str() {
            "iter" => true,
            "chain" | "rev" | "skip" | "take" | "filter" | "take_while" | "skip_while" => {
                gives_references(&it.receiver)
            }
            _ => false,
        },
        _ => false,
    }
}

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

/// Whether an expression is plain, or a tuple, an array or a struct of what is.
pub(super) fn is_made_of_plain(expr: &syn::Expr) -> bool {
    match bare(expr) {
        syn::Expr::Tuple(it) => it.elems.iter().all(is_made_of_plain),
        syn::Expr::Array(it) => it.elems.iter().all(is_made_of_plain),
        syn::Expr::Repeat(it) => is_made_of_plain(&it.expr),
        syn::Expr::Struct(it) => it.fields.iter().all(|field| is_made_of_plain(&field.expr)),
        syn::Expr::Call(it) => is_constructor(&it.func) && it.args.iter().all(is_made_of_plain),
        other => is_plain(other),
    }
}

/// Whether what is called is a variant, by its path.
fn is_constructor(function: &syn::Expr) -> bool {
    matches!(function, syn::Expr::Path(it) if is_variant(&it.path))
}

/// Whether an expression may be written twice, or left out: a number, a name, a part of one.
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

/// Whether an expression is an iterator, as far as its syntax shows.
pub(super) fn is_iterator(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Paren(it) => is_iterator(&it.expr),
        syn::Expr::Range(_) => true,
        syn::Expr::MethodCall(it) => match (shared(&it.method).as_str(), it.args.len()) {
            ("iter" | "into_iter", 0) => true,
            ("enumerate" | "rev" | "copied" | "cloned", 0) => is_iterator(&it.receiver),
            ("flatten", 0) => is_iterator(&it.receiver),
            (
                "map" | "map_while" | "filter" | "filter_map" | "take_while" | "skip_while" | "zip"
                | "chain" | "step_by" | "take" | "skip",
                1,
            )
            | ("scan", 2) => is_iterator(&it.receiver),
            ("windows" | "chunks" | "chunks_exact", 1) => true,
            _ => false,
        },
        _ => false,
    }
}

/// The name of a method without what says that it lends what may be changed.
pub(super) fn shared(method: &syn::Ident) -> String {
    let name = text(method);
    name.strip_suffix("_mut").map_or(name.clone(), str::to_owned)
}

/// Whether a closure stands somewhere in a chain.
pub(super) fn is_linked(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Paren(it) => is_linked(&it.expr),
        syn::Expr::MethodCall(it) => {
            let link = [
                "map",
                "map_while",
                "filter",
                "filter_map",
                "take_while",
                "skip_while",
                "scan",
                "flatten",
            ];
            link.iter().any(|link| it.method == link) || is_linked(&it.receiver)
        }
        _ => false,
    }
}

/// Whether a name stands somewhere in an expression. Answers yes too often rather than too rarely.
pub(super) fn names(expr: &impl ToTokens, name: &str) -> bool {
    fn any(tokens: proc_macro2::TokenStream, name: &str) -> bool {
        tokens.into_iter().any(|token| match token {
            proc_macro2::TokenTree::Ident(ident) => ident == name,
            proc_macro2::TokenTree::Group(group) => any(group.stream(), name),
            _ => false,
        })
    }
    any(quote! { #expr }, name)
}

/// Whether a path is that of a variant: a constant has no small letters.
pub(super) fn is_variant(path: &syn::Path) -> bool {
    let last = last_segment(path);
    path.segments.len() > 1
        && last.starts_with(|first: char| first.is_uppercase())
        && last.contains(|letter: char| letter.is_lowercase())
}

/// The name of a type without its modules.
pub fn last_ident(ty: &syn::Type) -> Option<&syn::Ident> {
    match ty {
        syn::Type::Path(it) => it.path.segments.last().map(|segment| &segment.ident),
        _ => None,
    }
}

/// The last name of a path.
pub(super) fn last_segment(path: &syn::Path) -> String {
    path.segments.last().map(|segment| text(&segment.ident)).unwrap_or_default()
}
