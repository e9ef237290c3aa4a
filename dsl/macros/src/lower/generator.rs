//! Functions that give an iterator, `fn edges(&self) -> impl Iterator<Item = Edge>`.
//!
//! In the tree such a function takes a closure, [`EACH`], to which it hands each item in turn: what the iterator gives is
//! gone through by its own loop, and the body of whoever goes through it stands in the place of the closure.
//!
//! Invariants: the body ends in the iterator, and nothing leaves it before.

use bessemer_ir::tree::EACH;
use proc_macro2::Span;
use syn::parse_quote;

use super::closure::without_returns;
use super::link::{is_range, pairs};
use super::refuse::{self, Refusals};
use crate::closures;

/// The items of the iterator that a function gives; none if it gives something else.
pub fn items(signature: &syn::Signature) -> Option<&syn::Type> {
    let syn::ReturnType::Type(_, ty) = &signature.output else { return None };
    let syn::Type::ImplTrait(it) = &**ty else { return None };
    it.bounds.iter().find_map(closures::items_of)
}

/// Lets a function that gives an iterator hand its items to a closure; says whether it is one.
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
    *iterator = parse_quote! { for #pattern in #iterator { #each(#value) } };
    signature.inputs.push(parse_quote! { #each: impl FnMut(#item) });
    signature.output = syn::ReturnType::Default;
    true
}

/// A pattern for an item of an iterator, and the item by the names in it.
pub(super) fn named_item(iterator: &syn::Expr) -> (syn::Pat, syn::Expr) {
    Names { given: 0 }.of(iterator)
}

/// Names for the items of an iterator.
struct Names {
    given: usize,
}

impl Names {
    /// A pattern for an item, and the item by the names in it: pairs have no name of their own.
    fn of(&mut self, iterator: &syn::Expr) -> (syn::Pat, syn::Expr) {
        let Some((first, second)) = pairs(iterator) else {
            return self.one(is_range(iterator));
        };
        let left = match first {
            Some(first) => self.of(first),
            None => self.one(true),
        };
        pair(left, self.of(second))
    }

    fn one(&mut self, counts: bool) -> (syn::Pat, syn::Expr) {
        self.given += 1;
        let name = match (counts, self.given) {
            (true, _) => "i".to_owned(),
            (false, 1) => "item".to_owned(),
            (false, more) => format!("item_{more}"),
        };
        let name = syn::Ident::new(&name, Span::mixed_site());
        (parse_quote! { #name }, parse_quote! { #name })
    }
}

fn pair(
    (left, one): (syn::Pat, syn::Expr),
    (right, other): (syn::Pat, syn::Expr),
) -> (syn::Pat, syn::Expr) {
    (parse_quote! { (#left, #right) }, parse_quote! { (#one, #other) })
}
