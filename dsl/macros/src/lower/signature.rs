//! Checks signatures and types as far as syntax shows that they are unsupported.

use bessemer_tree::{NO_SLOT, Param, Ty};
use proc_macro2::Span;
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

use super::names::{SELF, site, text};
use super::refuse::Refusals;
use super::{pattern, refuse};
use crate::closures;

/// Name of `self` in the witness copy.
pub const RECEIVER: &str = "__self";

/// A parameter for the tree and the companions.
pub struct Parameter {
    /// Parameter of the tree, without its slot.
    pub param: Param,
    /// Name in the witness copy.
    pub ident: syn::Ident,
    /// Pattern in the witness copy.
    pub pattern: proc_macro2::TokenStream,
    /// Type; for a closure or an iterator, its substitute.
    pub ty: proc_macro2::TokenStream,
    /// Span of its type.
    pub place: Span,
}

/// Returns the parameters of a signature, and refuses what is unsupported.
pub fn parameters(signature: &syn::Signature, refusals: &mut Refusals) -> Vec<Parameter> {
    check_signature(signature, refusals);
    signature
        .inputs
        .iter()
        .filter_map(|input| parameter(input, &signature.generics, refusals))
        .collect()
}

fn parameter(
    input: &syn::FnArg,
    generics: &syn::Generics,
    refusals: &mut Refusals,
) -> Option<Parameter> {
    match input {
        syn::FnArg::Receiver(it) => {
            let ty = match &it.kind {
                syn::ReceiverKind::Reference(_, _, mutable) => quote! { & #mutable Self },
                syn::ReceiverKind::Value => quote! { Self },
                _ => {
                    refusals.add(it.self_token.span, refuse::RECEIVER);
                    return None;
                }
            };
            let receiver = syn::Ident::new(RECEIVER, it.self_token.span);
            let mutability = &it.mutability;
            let (site, mutable) = (site(&it.self_token), mutability.is_some());
            let (slot, closure, items) = (NO_SLOT, false, false);
            Some(Parameter {
                param: Param { name: SELF.into(), slot, site, closure, items, mutable },
                pattern: quote! { #mutability #receiver },
                ident: receiver,
                ty,
                place: Span::call_site(),
            })
        }
        syn::FnArg::Typed(it) => {
            let stands_for = closures::stands_for(&it.ty, generics);
            if stands_for.is_none() {
                check_type(&it.ty, refusals);
            }
            let ident = pattern::simple_name(&mut it.pat.clone(), refusals)?;
            let (name, slot, site) = (text(&ident), NO_SLOT, site(&ident));
            let (closure, items) =
                (stands_for.is_some(), stands_for.as_ref().is_some_and(|it| it.items));
            // What is lent is taken from, whatever its name is.
            let lent = items && matches!(&*it.ty, syn::Type::Reference(_));
            let mutable = matches!(&*it.pat, syn::Pat::Ident(it) if it.mutability.is_some());
            let mutable = mutable || lent;
            Some(Parameter {
                param: Param { name, slot, site, closure, items, mutable },
                pattern: it.pat.to_token_stream(),
                ident,
                ty: stands_for.map_or_else(|| it.ty.to_token_stream(), |it| it.ty),
                place: named_part(&it.ty),
            })
        }
    }
}

/// Returns the span of the name in a type, behind references and brackets.
pub fn named_part(ty: &syn::Type) -> Span {
    match ty {
        syn::Type::Reference(it) => named_part(&it.elem),
        syn::Type::Array(it) => named_part(&it.elem),
        syn::Type::Slice(it) => named_part(&it.elem),
        syn::Type::Path(it) => {
            it.path.segments.last().map_or_else(|| ty.span(), |it| it.ident.span())
        }
        _ => ty.span(),
    }
}

/// Returns true if a function returns a reference.
pub fn gives_reference(signature: &syn::Signature) -> bool {
    let syn::ReturnType::Type(_, ty) = &signature.output else { return false };
    matches!(&**ty, syn::Type::Reference(it) if !is_name(it))
}

/// Returns true if a function returns a reference to a value, which is a place; a slice is a value.
pub fn lends(signature: &syn::Signature) -> bool {
    let syn::ReturnType::Type(_, ty) = &signature.output else { return false };
    matches!(&**ty, syn::Type::Reference(it) if !matches!(*it.elem, syn::Type::Slice(_)) && !is_name(it))
}

/// Returns true if the syntax of a function's result shows that it borrows.
pub fn borrows(signature: &syn::Signature) -> bool {
    struct Borrows(bool);
    impl<'ast> Visit<'ast> for Borrows {
        fn visit_type_reference(&mut self, it: &'ast syn::TypeReference) {
            self.0 |= !is_name(it);
        }
        fn visit_lifetime(&mut self, _: &'ast syn::Lifetime) {
            self.0 = true;
        }
    }
    let mut found = Borrows(false);
    found.visit_return_type(&signature.output);
    found.0
}

/// Names a destructured parameter and moves its pattern into the body: `(x, y): (f64, f64)` becomes `x_y`, and `let (x,
/// y) = x_y;`.
pub fn name_parts(signature: &mut syn::Signature, body: &mut syn::Block) {
    let mut taken: Vec<String> = Vec::new();
    Names(|it: &syn::PatIdent| taken.push(text(&it.ident))).visit_signature(signature);
    let mut apart = Vec::new();
    for input in &mut signature.inputs {
        let syn::FnArg::Typed(it) = input else { continue };
        if matches!(&*it.pat, syn::Pat::Ident(_)) {
            continue;
        }
        let mut parts = Vec::new();
        Names(|it: &syn::PatIdent| parts.push(text(&it.ident))).visit_pat(&it.pat);
        let mut name = if parts.is_empty() { "unused".to_owned() } else { parts.join("_") };
        while taken.contains(&name) {
            name.push_str("_parts");
        }
        taken.push(name.clone());
        let name = syn::Ident::new(&name, it.pat.span());
        let pattern = std::mem::replace(&mut *it.pat, syn::parse_quote!(#name));
        apart.push(syn::parse_quote! { let #pattern = #name; });
    }
    body.stmts.splice(0..0, apart);
}

/// Visitor that calls a closure for each name that patterns bind.
pub(super) struct Names<F>(pub(super) F);

impl<'ast, F: FnMut(&syn::PatIdent)> Visit<'ast> for Names<F> {
    fn visit_pat_ident(&mut self, it: &'ast syn::PatIdent) {
        (self.0)(it);
        visit::visit_pat_ident(self, it);
    }
}

fn check_signature(signature: &syn::Signature, refusals: &mut Refusals) {
    if let Some(token) = &signature.asyncness {
        refusals.add(token.span, refuse::ASYNC);
    }
    if let syn::Safety::Unsafe(token) = &signature.safety {
        refusals.add(token.span, refuse::UNSAFE);
    }
    if let Some(abi) = &signature.abi {
        refusals.add(abi.extern_token.span, refuse::EXTERN);
    }
    if let syn::ReturnType::Type(_, ty) = &signature.output {
        match &**ty {
            // What is lent; which function may do so says the walk.
            syn::Type::Reference(it) if is_name(it) => {}
            syn::Type::Reference(it) => match &*it.elem {
                syn::Type::Slice(slice) => check_type(&slice.elem, refusals),
                inner => check_type(inner, refusals),
            },
            syn::Type::Never(it) => refusals.add(it.bang_token.span, refuse::NEVER),
            ty => check_type(ty, refusals),
        }
    }
}

/// Refuses types that their syntax shows to be unsupported.
pub fn check_type(ty: &syn::Type, refusals: &mut Refusals) {
    Types { refusals, field: false }.visit_type(ty);
}

/// Checks the type of a struct's field, which contains no reference.
pub fn check_field(ty: &syn::Type, refusals: &mut Refusals) {
    Types { refusals, field: true }.visit_type(ty);
}

struct Types<'a> {
    refusals: &'a mut Refusals,
    field: bool,
}

impl<'ast> Visit<'ast> for Types<'_> {
    fn visit_type(&mut self, ty: &'ast syn::Type) {
        let reason = match ty {
            syn::Type::Ptr(_) => refuse::POINTER,
            syn::Type::Reference(it) if is_name(it) => return,
            syn::Type::Reference(it) if !self.field => match &*it.elem {
                // A slice that is passed.
                syn::Type::Slice(slice) => return self.visit_type(&slice.elem),
                syn::Type::ImplTrait(_) => refuse::LENT_PARAMETER,
                _ => return visit::visit_type(self, ty),
            },
            syn::Type::Slice(_) => refuse::SLICE,
            syn::Type::TraitObject(_) => refuse::TRAIT_OBJECT,
            syn::Type::ImplTrait(_) => refuse::IMPL_TRAIT,
            syn::Type::FnPtr(_) => refuse::FUNCTION_POINTER,
            syn::Type::Macro(_) => refuse::MACRO,
            syn::Type::Never(_) => refuse::NEVER,
            // Of a text or a slice, the more telling reason is its own.
            syn::Type::Reference(it) if self.field && !is_unsized(&it.elem) => {
                refuse::REFERENCE_FIELD
            }
            syn::Type::Path(it) => match refuse::named_type(&it.path) {
                Some(reason) => reason,
                None => return visit::visit_type(self, ty),
            },
            _ => return visit::visit_type(self, ty),
        };
        self.refusals.add(ty, reason);
    }

    fn visit_generic_argument(&mut self, argument: &'ast syn::GenericArgument) {
        match argument {
            // What it borrows would be held by more than one.
            syn::GenericArgument::Lifetime(it) if self.field => {
                self.refusals.add(it, refuse::REFERENCE_FIELD);
            }
            _ => visit::visit_generic_argument(self, argument),
        }
    }

    /// Skips the lengths of arrays, which rustc evaluates.
    fn visit_expr(&mut self, _: &'ast syn::Expr) {}
}

/// Returns true for `&str`, a name, which is a value.
pub(super) fn is_name(it: &syn::TypeReference) -> bool {
    let is_str = matches!(&*it.elem, syn::Type::Path(path) if path.path.is_ident(Ty::NAME));
    it.mutability.is_none() && is_str
}

fn is_unsized(ty: &syn::Type) -> bool {
    match ty {
        syn::Type::Slice(_) | syn::Type::TraitObject(_) => true,
        syn::Type::Path(it) => it.path.is_ident(Ty::NAME),
        _ => false,
    }
}
