//! Parameters that take closures or iterators: `f: impl Fn(f64) -> f64`, `f: F` with `F: Fn(f64) -> f64`, and `items:
//! impl IntoIterator<Item = f64>`.
//!
//! Builders cannot name such types, so they use a substitute: a function pointer, or the DSL's iterator. The C has a
//! copy of the function for each combination of closures; a function with an iterator is inlined at each call.

use proc_macro2::TokenStream;
use quote::quote;
use syn::visit_mut::{self, VisitMut};
use syn::{GenericParam, TypeParamBound, WherePredicate};

use crate::lower::refuse;

/// Substitute in the builder for a type that it cannot name.
pub struct StandsFor {
    /// Substitute type.
    pub ty: TokenStream,
    /// True if it replaces an iterator.
    pub items: bool,
}

/// Returns the substitute for the type of a closure or iterator parameter; none for another type.
pub fn stands_for(ty: &syn::Type, generics: &syn::Generics) -> Option<StandsFor> {
    match ty {
        syn::Type::ImplTrait(it) => it.bounds.iter().find_map(of_bound),
        syn::Type::Path(it) if it.qself.is_none() => {
            let name = it.path.get_ident()?;
            bounds_of(generics, name).find_map(of_bound)
        }
        // An iterator behind `&mut`: the caller goes on with the items that are left.
        syn::Type::Reference(it) if it.mutability.is_some() => {
            let of = stands_for(&it.elem, generics).filter(|it| it.items)?;
            let ty = of.ty;
            Some(StandsFor { ty: quote! { &mut #ty }, items: true })
        }
        _ => None,
    }
}

/// Returns the generic parameters of a function without the types of its closures and iterators, which builders do
/// not need.
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
            predicates.into_iter().filter(|it| !about(it).is_some_and(&is_closure)).collect();
        if clause.predicates.is_empty() {
            rest.where_clause = None;
        }
    }
    if rest.params.is_empty() {
        (rest.lt_token, rest.gt_token) = (None, None);
    }
    rest
}

/// Returns the signature with a name for each type that only a bound describes, and without `?Sized`.
/// Examples: `rng: &mut impl Rng`, `gain: impl Into<f64>`.
pub fn with_names(signature: &syn::Signature) -> syn::Signature {
    let mut named = Interfaces(Vec::new());
    let mut signature = signature.clone();
    signature.inputs.iter_mut().for_each(|input| named.visit_fn_arg_mut(input));
    signature.generics.params.extend(named.0);
    for param in &mut signature.generics.params {
        let GenericParam::Type(it) = param else { continue };
        let bounds = std::mem::take(&mut it.bounds).into_iter();
        it.bounds = bounds.filter(|bound| !is_relaxed(bound)).collect();
    }
    signature
}

/// Traits of Rust that values of the DSL have.
const OF_VALUES: [&str; 7] = ["Clone", "Copy", "Debug", "Default", "Into", "Ord", "PartialOrd"];

/// Returns true if a bound is one on a value: an interface, or a trait of Rust that values have, such as `Into`. Those of
/// closures and iterators represent no type.
fn is_of_value(bound: &TypeParamBound) -> bool {
    let TypeParamBound::Trait(it) = bound else { return false };
    let is_known =
        || it.path.segments.last().is_some_and(|last| OF_VALUES.iter().any(|of| last.ident == of));
    of_bound(bound).is_none() && (refuse::known_trait(&it.path).is_none() || is_known())
}

/// Returns true if a bound is `?Sized`.
pub fn is_relaxed(bound: &TypeParamBound) -> bool {
    matches!(bound, TypeParamBound::Trait(it) if it.maybe.is_some())
}

/// The names of types that only bounds describe.
struct Interfaces(Vec<GenericParam>);

impl VisitMut for Interfaces {
    fn visit_type_mut(&mut self, ty: &mut syn::Type) {
        match ty {
            syn::Type::ImplTrait(it) if !it.bounds.iter().any(is_of_value) => {}
            syn::Type::ImplTrait(it) => {
                let name = quote::format_ident!("Impl{}", self.0.len());
                let bounds = &it.bounds;
                self.0.push(syn::parse_quote! { #name: #bounds });
                *ty = syn::parse_quote! { #name };
            }
            _ => visit_mut::visit_type_mut(self, ty),
        }
    }
}

/// Returns the bounds on the type called `name`.
pub fn bounds_of<'g>(
    generics: &'g syn::Generics,
    name: &'g syn::Ident,
) -> impl Iterator<Item = &'g TypeParamBound> {
    let own = generics.params.iter().filter_map(move |param| match param {
        GenericParam::Type(it) if it.ident == *name => Some(&it.bounds),
        _ => None,
    });
    let clause = generics.where_clause.iter().flat_map(|clause| &clause.predicates);
    let further = clause.filter_map(move |predicate| match predicate {
        WherePredicate::Type(it) if bounded(predicate)?.is_ident(name) => Some(&it.bounds),
        _ => None,
    });
    own.chain(further).flatten()
}

/// Returns the type that a predicate bounds.
fn bounded(predicate: &WherePredicate) -> Option<&syn::Path> {
    match predicate {
        WherePredicate::Type(it) => match &it.bounded_ty {
            syn::Type::Path(it) => Some(&it.path),
            _ => None,
        },
        _ => None,
    }
}

/// Returns the type parameter of a predicate; `I::IntoIter: Clone` is about `I`.
fn about(predicate: &WherePredicate) -> Option<&syn::Ident> {
    bounded(predicate)?.segments.first().map(|first| &first.ident)
}

fn of_bound(bound: &TypeParamBound) -> Option<StandsFor> {
    let closure = of_closure(bound).map(|ty| StandsFor { ty, items: false });
    closure.or_else(|| {
        let mut item = items_of(bound)?.clone();
        Unnamed.visit_type_mut(&mut item);
        Some(StandsFor { ty: quote! { ::bessemer::generate::Items<#item> }, items: true })
    })
}

/// Converts the bound `Fn(f64) -> f64` to `fn(f64) -> f64`.
fn of_closure(bound: &TypeParamBound) -> Option<TokenStream> {
    let TypeParamBound::Trait(bound) = bound else { return None };
    let last = bound.path.segments.last()?;
    let syn::PathArguments::Parenthesized(signature) = &last.arguments else { return None };
    if !["Fn", "FnMut", "FnOnce"].iter().any(|name| last.ident == name) {
        return None;
    }
    let (inputs, output) = (&signature.inputs, &signature.output);
    Some(quote! { fn(#inputs) #output })
}

/// Traits of iterators, and of types that convert to one.
const ITERATORS: [&str; 4] =
    ["Iterator", "DoubleEndedIterator", "ExactSizeIterator", "IntoIterator"];

/// Returns the item type of an iterator bound, `Iterator<Item = f64>`; none for another bound.
pub fn items_of(bound: &TypeParamBound) -> Option<&syn::Type> {
    let TypeParamBound::Trait(bound) = bound else { return None };
    let last = bound.path.segments.last()?;
    let syn::PathArguments::AngleBracketed(arguments) = &last.arguments else { return None };
    if !ITERATORS.iter().any(|name| last.ident == name) {
        return None;
    }
    arguments.args.iter().find_map(|argument| match argument {
        syn::GenericArgument::AssocType(it) if it.ident == "Item" => Some(&it.ty),
        _ => None,
    })
}

/// Visitor that removes the names of lifetimes, which the builder does not declare.
struct Unnamed;

impl VisitMut for Unnamed {
    fn visit_type_reference_mut(&mut self, ty: &mut syn::TypeReference) {
        visit_mut::visit_type_reference_mut(self, ty);
        ty.lifetime = None;
    }

    fn visit_lifetime_mut(&mut self, it: &mut syn::Lifetime) {
        *it = syn::Lifetime::new("'_", it.apostrophe);
    }
}
