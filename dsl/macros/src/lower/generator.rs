//! Iterators as values: the result of `fn edges(&self) -> impl Iterator<Item = Edge>`, the receiver of `.map(…)`, or
//! an argument as in `mean(values.iter().rev())`.
//!
//! In the tree each of them passes its items to a closure, [`EACH`]: it is a loop that is inlined where the iterator
//! is consumed, with the consumer's body as the closure. A function has this closure as a parameter; an iterator
//! expression is a closure itself. The witness copy keeps the iterator expression, and records the types of its
//! items.
//!
//! Invariants: the body of such a function ends in the iterator, and has no early exit.

use bessemer_tree as tree;
use bessemer_tree::{EACH, ExprKind, NO_SLOT};
use proc_macro2::Span;
use quote::quote_spanned;
use syn::parse_quote;
use syn::spanned::Spanned;

use super::closure::without_returns;
use super::link::{is_range, pairs};
use super::names::{UNIT, plain};
use super::refuse::{self, Refusals};
use super::walk::Lowering;
use crate::closures;

/// Returns the item type of the iterator that a function returns; none for another result.
pub fn items(signature: &syn::Signature) -> Option<&syn::Type> {
    let syn::ReturnType::Type(_, ty) = &signature.output else { return None };
    let syn::Type::ImplTrait(it) = &**ty else { return None };
    it.bounds.iter().find_map(closures::items_of)
}

/// Makes a function that returns an iterator pass its items to a closure; returns false for another function.
pub fn hand_on(
    signature: &mut syn::Signature,
    body: &mut syn::Block,
    refusals: &mut Refusals,
) -> bool {
    let Some(item) = items(signature).cloned() else { return false };
    let each = syn::Ident::new(EACH, Span::call_site());
    without_returns(body, refusals);
    let Some(syn::Stmt::Expr(iterator, None)) = body.stmts.last_mut() else {
        refusals.add(&signature.output, refuse::ITERATOR_TAIL);
        return true;
    };
    let (pattern, value) = named_item(iterator);
    // Behind `in` a struct needs parentheses.
    let items: syn::Expr = match begins_with_struct(iterator) {
        true => parse_quote! { (#iterator) },
        false => iterator.clone(),
    };
    *iterator = parse_quote! { for #pattern in #items { #each(#value) } };
    signature.inputs.push(parse_quote! { #each: impl FnMut(#item) });
    signature.output = syn::ReturnType::Default;
    true
}

impl Lowering {
    /// Returns the closure that yields each item.
    pub(super) fn handing(&mut self, expr: &mut syn::Expr) -> ExprKind {
        let (whole, (pattern, item)) = (expr.clone(), named_item(expr));
        let each = syn::Ident::new(EACH, Span::call_site());
        let mut through: syn::ExprForLoop = parse_quote! { for #pattern in () { #each(#item); } };
        *through.expr = expr.clone();
        // Whatever is in the place of handing it on means other names.
        let outer = std::mem::replace(&mut self.apart, true);
        let body = self.scoped(|walk| walk.for_loop(&mut through)).unwrap_or(UNIT);
        self.apart = outer;
        let syn::ExprForLoop { pat, expr: items, body: mut pass, .. } = through;
        if let Some(last) = pass.stmts.last_mut()
            && let syn::Stmt::Expr(syn::Expr::Call(call), _) = last
        {
            *last = syn::Stmt::Expr(call.args[0].clone(), None);
        }
        let stmts = &pass.stmts;
        *expr = syn::Expr::Verbatim(quote_spanned! { items.span() =>
            __items(::core::iter::IntoIterator::into_iter(#items).map(|#pat| { #(#stmts)* }))
        });
        let body = Box::new(plain(body, &whole));
        let (name, slot) = (EACH.to_owned(), NO_SLOT);
        let each = tree::Pattern::Name { name, slot, mutable: false, inner: None };
        ExprKind::Closure(tree::Closure { name: None, parameters: vec![each], body })
    }
}

/// Returns true if an expression begins with a struct literal.
fn begins_with_struct(expr: &syn::Expr) -> bool {
    use syn::Expr::{Assign, Binary, Call, Cast, Field, Index, MethodCall, Range, Struct, Try};
    match expr {
        Struct(_) => true,
        MethodCall(it) => begins_with_struct(&it.receiver),
        Field(it) => begins_with_struct(&it.base),
        Index(it) => begins_with_struct(&it.expr),
        Call(it) => begins_with_struct(&it.func),
        Try(it) => begins_with_struct(&it.expr),
        Cast(it) => begins_with_struct(&it.expr),
        Binary(it) => begins_with_struct(&it.left),
        Assign(it) => begins_with_struct(&it.left),
        Range(it) => it.start.as_deref().is_some_and(begins_with_struct),
        _ => false,
    }
}

/// Returns a pattern for an item of an iterator, and the item as an expression of the names in it.
pub(super) fn named_item(iterator: &syn::Expr) -> (syn::Pat, syn::Expr) {
    named(iterator, &mut Vec::new())
}

/// Returns the pattern and the expression of an iterator beside named items: pairs have no name of their own.
fn named(iterator: &syn::Expr, given: &mut Vec<&str>) -> (syn::Pat, syn::Expr) {
    let Some((first, second)) = pairs(iterator) else { return one(is_range(iterator), given) };
    let (left, one) = match first {
        Some(first) => named(first, given),
        None => one(true, given),
    };
    let (right, other) = named(second, given);
    (parse_quote! { (#left, #right) }, parse_quote! { (#one, #other) })
}

fn one(counts: bool, given: &mut Vec<&str>) -> (syn::Pat, syn::Expr) {
    let name = if counts { "i" } else { "item" };
    let same = given.iter().filter(|it| !counts || **it == name).count();
    given.push(name);
    let name = if same == 0 { name.to_owned() } else { format!("{name}_{}", same + 1) };
    let name = syn::Ident::new(&name, Span::mixed_site());
    (parse_quote! { #name }, parse_quote! { #name })
}
