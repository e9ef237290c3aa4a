//! Parameters that take closures: `f: impl Fn(f64) -> f64`, or `f: F` with `F: Fn(f64) -> f64`.
//!
//! Such a function is built with a function pointer in the closure's place, since a closure has no type that
//! a builder could name; what becomes C is a copy of the function for each closure that it is called with.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{GenericParam, TypeParamBound, WherePredicate};

/// The function pointer that stands for a closure of type `ty` in the builder; none if it is another type.
pub fn pointer(ty: &syn::Type, generics: &syn::Generics) -> Option<TokenStream> {
    match ty {
        syn::Type::ImplTrait(it) => it.bounds.iter().find_map(of_bound),
        syn::Type::Path(it) if it.qself.is_none() => {
            let name = it.path.get_ident()?;
            bounds_of(generics, name).find_map(of_bound)
        }
        _ => None,
    }
}

/// The parameters of a function without the types of its closures: those have no part in what is built.
pub fn without(generics: &syn::Generics) -> syn::Generics {
    let is_closure =
        |name: &syn::Ident| bounds_of(generics, name).any(|bound| of_bound(bound).is_some());
    let mut rest = generics.clone();
    rest.params = generics
        .params
        .iter()
        .filter(|param| !matches!(param, GenericParam::Type(it) if is_closure(&it.ident)))
        .cloned()
        .collect();
    if let Some(clause) = &mut rest.where_clause {
        let predicates = std::mem::take(&mut clause.predicates);
        clause.predicates =
            predicates.into_iter().filter(|it| !bounded(it).is_some_and(&is_closure)).collect();
        if clause.predicates.is_empty() {
            rest.where_clause = None;
        }
    }
    if rest.params.is_empty() {
        (rest.lt_token, rest.gt_token) = (None, None);
    }
    rest
}

/// The bounds on the type called `name`.
fn bounds_of<'g>(
    generics: &'g syn::Generics,
    name: &'g syn::Ident,
) -> impl Iterator<Item = &'g TypeParamBound> {
    let own = generics.params.iter().filter_map(move |param| match param {
        GenericParam::Type(it) if it.ident == *name => Some(&it.bounds),
        _ => None,
    });
    let clause = generics.where_clause.iter().flat_map(|clause| &clause.predicates);
    let further = clause.filter_map(move |predicate| match predicate {
        WherePredicate::Type(it) if bounded(predicate) == Some(name) => Some(&it.bounds),
        _ => None,
    });
    own.chain(further).flatten()
}

/// The name that a predicate is about.
fn bounded(predicate: &WherePredicate) -> Option<&syn::Ident> {
    match predicate {
        WherePredicate::Type(it) => match &it.bounded_ty {
            syn::Type::Path(it) => it.path.get_ident(),
            _ => None,
        },
        _ => None,
    }
}

/// `Fn(f64) -> f64` as `fn(f64) -> f64`.
fn of_bound(bound: &TypeParamBound) -> Option<TokenStream> {
    let TypeParamBound::Trait(bound) = bound else { return None };
    let last = bound.path.segments.last()?;
    let syn::PathArguments::Parenthesized(signature) = &last.arguments else { return None };
    if !["Fn", "FnMut", "FnOnce"].iter().any(|name| last.ident == name) {
        return None;
    }
    let (inputs, output) = (&signature.inputs, &signature.output);
    Some(quote! { fn(#inputs) #output })
}
