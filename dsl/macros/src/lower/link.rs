//! Iterator adapters that determine the form of a loop; only this module knows their names.
//!
//! Must not know: types. A method with such a name may belong to another type; then its receiver is no source of a
//! loop.

use bessemer_tree::Grouping;

use super::names::{SELF, text};
use super::rewrite;
use super::syntax::bare;

/// A method of an iterator, or of a type with elements.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Link {
    /// Iterates over references to the elements.
    Iter,
    /// Iterates over the elements themselves, or over references if the receiver is one.
    IntoIter,
    /// Copies the items behind references.
    Copied,
    /// Iterates over groups of elements.
    Group(Grouping),
    Enumerate,
    Rev,
    Skip,
    Take,
    StepBy,
    Zip,
    Chain,
    Cycle,
    /// Omits items for which a closure decides it.
    Sift,
}

impl Link {
    /// Classifies a call by its name and its number of arguments.
    pub(super) fn of(it: &syn::ExprMethodCall) -> Option<Link> {
        Some(match (shared(&it.method).as_str(), it.args.len()) {
            ("iter", 0) => Link::Iter,
            ("into_iter", 0) => Link::IntoIter,
            ("copied" | "cloned", 0) => Link::Copied,
            ("windows", 1) => Link::Group(Grouping::Windows),
            ("chunks", 1) => Link::Group(Grouping::All),
            ("chunks_exact", 1) => Link::Group(Grouping::Whole),
            ("enumerate", 0) => Link::Enumerate,
            ("rev", 0) => Link::Rev,
            ("skip", 1) => Link::Skip,
            ("take", 1) => Link::Take,
            ("step_by", 1) => Link::StepBy,
            ("zip", 1) => Link::Zip,
            ("chain", 1) => Link::Chain,
            ("cycle", 0) => Link::Cycle,
            ("filter" | "take_while" | "skip_while", 1) => Link::Sift,
            _ => return None,
        })
    }

    /// Returns true if it reverses or omits items, but changes none.
    fn keeps(self) -> bool {
        matches!(self, Link::Rev | Link::Skip | Link::Take | Link::Sift)
    }
}

/// Returns the name of a method without `_mut`.
fn shared(method: &syn::Ident) -> String {
    let name = text(method);
    name.strip_suffix("_mut").map_or(name.clone(), str::to_owned)
}

/// Returns the iterators of a pair's two parts; the first is none for `enumerate`.
pub(super) fn pairs(expr: &syn::Expr) -> Option<(Option<&syn::Expr>, &syn::Expr)> {
    let syn::Expr::MethodCall(it) = bare(expr) else { return None };
    match Link::of(it)? {
        Link::Enumerate => Some((None, &it.receiver)),
        Link::Zip => Some((Some(&it.receiver), it.args.first()?)),
        link if link.keeps() => pairs(&it.receiver),
        _ => None,
    }
}

/// Returns true if the syntax of an iterator shows that it yields references.
pub(super) fn gives_references(expr: &syn::Expr) -> bool {
    match bare(expr) {
        syn::Expr::Reference(_) => true,
        syn::Expr::MethodCall(it) => match Link::of(it) {
            Some(Link::Iter) => text(&it.method) == shared(&it.method),
            Some(link) => (link == Link::Chain || link.keeps()) && gives_references(&it.receiver),
            None => false,
        },
        _ => false,
    }
}

/// Returns true if an expression is an iterator through elements or numbers, one after the other, as far as its syntax
/// shows.
pub(super) fn is_source(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Paren(it) => is_source(&it.expr),
        syn::Expr::Range(_) => true,
        syn::Expr::MethodCall(it) => match Link::of(it) {
            // What a method has itself is no array: its `iter` is its author's.
            Some(Link::Iter) => !is_self(&it.receiver),
            Some(Link::IntoIter | Link::Group(_)) => true,
            // What is written, or iterated otherwise, is in one of two: a loop for each.
            Some(Link::Chain) => is_lent(&it.receiver) && is_array(&it.args[0]),
            None | Some(Link::Sift) => false,
            Some(_) => is_source(&it.receiver),
        },
        _ => false,
    }
}

/// Returns true if an expression is `values.iter()`, which may be an iterator of the author's own.
pub(super) fn is_iter(expr: &syn::Expr) -> bool {
    matches!(expr, syn::Expr::MethodCall(it) if Link::of(it) == Some(Link::Iter))
}

/// Returns true if an expression is `self`.
fn is_self(expr: &syn::Expr) -> bool {
    matches!(expr, syn::Expr::Path(it) if it.path.get_ident().is_some_and(|it| text(it) == SELF))
}

/// Returns true if an iterator yields shared references to elements, from the first on.
fn is_lent(expr: &syn::Expr) -> bool {
    match bare(expr) {
        syn::Expr::Reference(it) => it.mutability.is_none(),
        syn::Expr::MethodCall(it) => match Link::of(it) {
            Some(Link::Iter) => text(&it.method) == shared(&it.method),
            Some(Link::Copied | Link::Skip | Link::Take) => is_lent(&it.receiver),
            Some(Link::Chain) => is_source(expr),
            _ => false,
        },
        _ => false,
    }
}

/// Returns true if the source of an iterator is an array, or its elements.
fn is_array(expr: &syn::Expr) -> bool {
    match bare(expr) {
        syn::Expr::Range(_) => false,
        syn::Expr::Call(it) => rewrite::is_once(it),
        syn::Expr::MethodCall(it) if Link::of(it) == Some(Link::IntoIter) => is_array(&it.receiver),
        syn::Expr::MethodCall(_) | syn::Expr::Reference(_) => is_lent(expr),
        _ => true,
    }
}

/// Returns true if a loop counts through a range.
pub(super) fn is_range(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Range(_) => true,
        syn::Expr::Paren(it) => is_range(&it.expr),
        syn::Expr::MethodCall(it) => {
            matches!(Link::of(it), Some(Link::Rev | Link::StepBy)) && is_range(&it.receiver)
        }
        _ => false,
    }
}
