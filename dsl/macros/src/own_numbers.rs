//! Author's interfaces for numbers, such as `trait Scalar { fn sin(self) -> Self; }`, whose methods have the names of
//! the numbers' own methods.
//!
//! Invariant: annotated items call the DSL's methods by the DSL's name, on any type. So a method with such a name
//! also gets the DSL's name, and a number's own method keeps priority.
//!
//! Must not know: companions and builders.

use quote::{ToTokens, format_ident};
use syn::visit_mut::{self, VisitMut};

use crate::{lower, owned};

/// Returns the DSL's name of a method that is named like one of numbers: annotated items call those by the DSL's name
/// on any type. It borrows, as its companion does, so that a number's own method has priority.
pub fn alias(method: &syn::TraitItemFn) -> Option<syn::TraitItem> {
    let (name, own) = (&method.sig.ident, owned::owned(&method.sig.ident)?);
    let mut signature = method.sig.clone();
    signature.ident = own;
    let moved = is_moved(&method.sig);
    let arguments: Vec<syn::Expr> = signature
        .inputs
        .iter_mut()
        .enumerate()
        .map(|(index, input)| match input {
            syn::FnArg::Receiver(it) if moved => {
                *it = syn::parse_quote!(&self);
                syn::parse_quote!(*self)
            }
            syn::FnArg::Receiver(_) => syn::parse_quote!(self),
            syn::FnArg::Typed(it) => {
                let name = format_ident!("__{index}");
                it.pat = syn::parse_quote!(#name);
                syn::parse_quote!(#name)
            }
        })
        .collect();
    let bounds = &mut signature.generics.make_where_clause().predicates;
    bounds.push(syn::parse_quote!(Self: Sized));
    if moved {
        bounds.push(syn::parse_quote!(Self: ::core::marker::Copy));
    }
    Some(syn::parse_quote! {
        #[doc(hidden)]
        #[allow(dead_code)]
        #signature { Self::#name(#(#arguments),*) }
    })
}

/// Returns true if a method has a second name under which it borrows its receiver.
pub fn is_borrowed(signature: &syn::Signature) -> bool {
    owned::owned(&signature.ident).is_some() && is_moved(signature)
}

/// Makes an implementation call the numbers' own methods of these names as methods: `f64::sin(self)` becomes
/// `self.sin()`, since the path could be either trait's.
pub fn by_methods(it: &mut syn::ItemImpl) {
    let names = it.items.iter().filter_map(|item| match item {
        syn::ImplItem::Fn(method) => owned::owned(&method.sig.ident).map(|_| &method.sig.ident),
        _ => None,
    });
    let names: Vec<String> = names.map(lower::text).collect();
    if !names.is_empty() {
        OfNumbers(names).visit_item_impl_mut(it);
    }
}

/// Visitor for calls of the names that an implementation redefines.
struct OfNumbers(Vec<String>);

impl VisitMut for OfNumbers {
    fn visit_expr_mut(&mut self, expr: &mut syn::Expr) {
        visit_mut::visit_expr_mut(self, expr);
        let syn::Expr::Call(it) = &*expr else { return };
        let syn::Expr::Path(function) = &*it.func else { return };
        let path = owned::of_libm(&function.path).unwrap_or_else(|| function.path.clone());
        let Some(name) = path.segments.last().map(|last| &last.ident) else { return };
        let home = match (&function.qself, path.segments.len()) {
            (Some(of), 1) => of.ty.to_token_stream().to_string(),
            (None, 2) => lower::text(&path.segments[0].ident),
            _ => return,
        };
        let is_number = bessemer_tree::number::is_number(home.trim());
        let mut arguments = it.args.iter();
        if is_number
            && self.0.contains(&lower::text(name))
            && let Some(receiver) = arguments.next()
        {
            *expr = syn::parse_quote! { (#receiver).#name(#(#arguments),*) };
        }
    }
}

/// Returns true if a method takes `self` by value.
fn is_moved(signature: &syn::Signature) -> bool {
    signature.receiver().is_some_and(|it| matches!(it.kind, syn::ReceiverKind::Value))
}
