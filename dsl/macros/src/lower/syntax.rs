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
    pairs(expr).is_some()
}

/// The links that turn round what comes, or leave some of it out, and change nothing of it.
const SAME: [&str; 6] = ["rev", "skip", "take", "filter", "take_while", "skip_while"];

/// The iterators that give the two of each pair, the first of which may be the number alone.
pub(super) fn pairs(expr: &syn::Expr) -> Option<(Option<&syn::Expr>, &syn::Expr)> {
    let syn::Expr::MethodCall(it) = bare(expr) else { return None };
    match text(&it.method).as_str() {
        "enumerate" => Some((None, &it.receiver)),
        "zip" => Some((Some(&it.receiver), it.args.first()?)),
        link if SAME.contains(&link) => pairs(&it.receiver),
        _ => None,
    }
}

/// Whether an iterator gives references, as far as its syntax shows.
pub(super) fn gives_references(expr: &syn::Expr) -> bool {
    match bare(expr) {
        syn::Expr::Reference(_) => true,
        syn::Expr::MethodCall(it) => match text(&it.method).as_str() {
            "iter" => true,
            link => (link == "chain" || SAME.contains(&link)) && gives_references(&it.receiver),
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

/// The links of a chain that take a closure or look into what comes, their arguments, and what they tell of what they
/// stand behind.
const LINKS: [(&str, usize, Link); 12] = [
    ("map", 1, Link::Any),
    ("flat_map", 1, Link::Iterator),
    ("map_while", 1, Link::Iterator),
    ("filter", 1, Link::Option),
    ("filter_map", 1, Link::Iterator),
    ("take_while", 1, Link::Iterator),
    ("skip_while", 1, Link::Iterator),
    ("scan", 2, Link::Iterator),
    ("flatten", 0, Link::Any),
    ("copied", 0, Link::Any),
    ("cloned", 0, Link::Any),
    ("enumerate", 0, Link::Iterator),
];

/// What a link tells of what it stands behind, if that gives no array of an author's.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Link {
    /// Nothing.
    Any,
    /// It is an iterator or an `Option`.
    Option,
    /// It is an iterator.
    Iterator,
}

fn link(it: &syn::ExprMethodCall) -> Option<Link> {
    let mut links = LINKS.iter();
    let found = links.find(|(name, count, _)| it.method == name && it.args.len() == *count);
    found.map(|(.., told)| *told)
}

/// Whether an expression is an iterator, as far as its syntax shows.
pub(super) fn is_iterator(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Paren(it) => is_iterator(&it.expr),
        syn::Expr::Range(_) => true,
        syn::Expr::MethodCall(it) if link(it).is_some() => {
            is_iterator(&it.receiver) || links(expr) == Some(Link::Iterator)
        }
        syn::Expr::MethodCall(it) => match (shared(&it.method).as_str(), it.args.len()) {
            ("iter" | "into_iter", 0) => true,
            ("rev" | "cycle", 0) => is_iterator(&it.receiver),
            ("zip" | "chain" | "step_by" | "take" | "skip", 1) => is_iterator(&it.receiver),
            ("windows" | "chunks" | "chunks_exact", 1) => true,
            _ => false,
        },
        _ => false,
    }
}

/// Whether an argument is an iterator. A closed range is a value.
pub(super) fn is_handed(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Paren(it) => is_handed(&it.expr),
        syn::Expr::Range(it) => matches!(it.limits, syn::RangeLimits::HalfOpen(_)),
        // An author's own method, which may give anything.
        syn::Expr::MethodCall(it) if it.args.is_empty() && is_self(&it.receiver) => false,
        other => is_iterator(other),
    }
}

fn is_self(expr: &syn::Expr) -> bool {
    matches!(expr, syn::Expr::Path(it) if it.path.is_ident("self"))
}

/// Whether what a chain ends in is an iterator, as far as its syntax shows: one that a function gives is told by its links,
/// or by an end that only iterators have, `alone`. Where neither tells, `.into_iter()` behind the call does.
pub(super) fn is_ended(it: &syn::ExprMethodCall, alone: bool) -> bool {
    let told = |link| link > Link::Any || alone;
    is_iterator(&it.receiver) || links(&it.receiver).is_some_and(told)
}

/// The most that a link tells of a chain that begins with a call; none of another expression.
fn links(expr: &syn::Expr) -> Option<Link> {
    let it = match expr {
        syn::Expr::Paren(it) => return links(&it.expr),
        syn::Expr::Call(_) => return Some(Link::Any),
        syn::Expr::MethodCall(it) => it,
        _ => return None,
    };
    let Some(told) = link(it) else { return Some(Link::Any) };
    // No element of a matrix is a pair.
    let pairs = matches!(it.args.first(), Some(syn::Expr::Closure(it))
        if matches!(it.inputs.first(), Some(syn::Pat::Tuple(_))));
    let told = if pairs { told.max(Link::Option) } else { told };
    Some(links(&it.receiver)?.max(told))
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
            let chained = || it.method == "chain" && it.args.first().is_some_and(is_linked);
            let links = || LINKS[..9].iter().any(|(link, ..)| it.method == link);
            links() || chained() || is_linked(&it.receiver)
        }
        _ => false,
    }
}

/// Whether a name stands somewhere in an expression. Answers yes too often rather than too rarely.
pub(super) fn names(expr: &impl ToTokens, name: &str) -> bool {
    times_named(expr, name) > 0
}

/// How often a name stands in an expression, as what it may be.
pub(super) fn times_named(expr: &impl ToTokens, name: &str) -> usize {
    fn count(tokens: proc_macro2::TokenStream, name: &str) -> usize {
        let of = |token| match token {
            proc_macro2::TokenTree::Ident(ident) => usize::from(ident == name),
            proc_macro2::TokenTree::Group(group) => count(group.stream(), name),
            _ => 0,
        };
        tokens.into_iter().map(of).sum()
    }
    count(quote! { #expr }, name)
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
