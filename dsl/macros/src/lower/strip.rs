//! Removes attributes and lifetimes from a copy of the author's code.
//!
//! Attributes that would make the C differ from the Rust are refused here.

use syn::visit_mut::{self, VisitMut};

use super::refuse::Refusals;
use super::signature::is_name;
use super::{loops, refuse};
use crate::conditions::{conditional, is_harmless};

/// Refuses the attributes of an item, field or method that would make the C differ from the Rust.
///
/// A `#[cfg]` above the DSL's attribute does not appear here, since rustc has applied it.
pub fn check_attributes(attributes: &[syn::Attribute], refusals: &mut Refusals) {
    for attribute in attributes {
        if is_conditional(attribute) {
            refusals.add(attribute.path(), refuse::CFG);
        }
    }
}

/// Returns true for an attribute that conditionally removes its item.
fn is_conditional(attribute: &syn::Attribute) -> bool {
    let path = attribute.path();
    path.is_ident("cfg") || path.is_ident("cfg_attr") && conditional(attribute).is_none()
}

/// Removes attributes and lifetimes from a copy of a function. A name, `&str`, is a value, so it lasts.
pub fn strip(signature: &mut syn::Signature, body: &mut syn::Block, refusals: &mut Refusals) {
    let mut strip = Strip { refusals };
    for input in &mut signature.inputs {
        strip.visit_fn_arg_mut(input);
    }
    strip.visit_return_type_mut(&mut signature.output);
    strip.visit_block_mut(body);
}

/// Names the lifetimes that an `impl` block omits, `Reader<'_>`, `From<&Reading>`.
pub fn name_lifetimes(block: &mut syn::ItemImpl) {
    struct Named(Vec<syn::Lifetime>);
    impl VisitMut for Named {
        fn visit_lifetime_mut(&mut self, it: &mut syn::Lifetime) {
            if it.to_string() == "'_" {
                let name = format!("'__{}", self.0.len());
                *it = syn::Lifetime::new(&name, proc_macro2::Span::mixed_site());
                self.0.push(it.clone());
            }
        }
        fn visit_type_reference_mut(&mut self, it: &mut syn::TypeReference) {
            it.lifetime.get_or_insert_with(|| syn::Lifetime::new("'_", it.and_token.span));
            visit_mut::visit_type_reference_mut(self, it);
        }
    }
    let mut named = Named(Vec::new());
    named.visit_type_mut(&mut block.self_ty);
    if let Some((path, _)) = &mut block.trait_ {
        named.visit_path_mut(path);
    }
    let declared =
        named.0.into_iter().map(|it| syn::GenericParam::Lifetime(syn::LifetimeParam::new(it)));
    block.generics.params = declared.chain(std::mem::take(&mut block.generics.params)).collect();
}

/// Writes the type of an `impl` block for `Self` in its bounds: items beside the block have these bounds, too.
pub fn name_owner(block: &mut syn::ItemImpl) {
    struct Owner(syn::Type);
    impl VisitMut for Owner {
        fn visit_type_mut(&mut self, ty: &mut syn::Type) {
            match ty {
                syn::Type::Path(it) if it.path.is_ident("Self") => *ty = self.0.clone(),
                _ => visit_mut::visit_type_mut(self, ty),
            }
        }
    }
    let mut owner = Owner((*block.self_ty).clone());
    let of_methods = block.items.iter_mut().filter_map(|item| match item {
        syn::ImplItem::Fn(method) => Some(&mut method.sig.generics),
        _ => None,
    });
    for generics in std::iter::once(&mut block.generics).chain(of_methods) {
        if let Some(clause) = &mut generics.where_clause {
            owner.visit_where_clause_mut(clause);
        }
    }
}

/// Returns the type of an `impl` block with lifetimes `'static`, for items beside the block, where its lifetimes are
/// not in scope.
pub fn lasting_type(ty: &syn::Type) -> syn::Type {
    let mut ty = ty.clone();
    Lasting.visit_type_mut(&mut ty);
    ty
}

/// Makes the lifetimes in the path of a trait `'static`.
pub fn lasting_path(path: &syn::Path) -> syn::Path {
    let mut path = path.clone();
    Lasting.visit_path_mut(&mut path);
    path
}

struct Lasting;

impl VisitMut for Lasting {
    fn visit_lifetime_mut(&mut self, it: &mut syn::Lifetime) {
        *it = syn::Lifetime::new("'static", it.apostrophe);
    }
}

struct Strip<'a> {
    refusals: &'a mut Refusals,
}

impl VisitMut for Strip<'_> {
    fn visit_attributes_mut(&mut self, attributes: &mut Vec<syn::Attribute>) {
        check_attributes(attributes, self.refusals);
        for attribute in attributes.drain(..).filter(|it| !is_conditional(it)) {
            let added = match attribute.path().is_ident("cfg_attr") {
                true => conditional(&attribute).unwrap_or_default(),
                false => vec![attribute.meta.clone()],
            };
            if !added.iter().all(|it| is_harmless(it.path())) {
                self.refusals.add(attribute.path(), refuse::ATTRIBUTE);
            }
        }
    }

    /// Skips an inner function, since it has its own attribute.
    fn visit_item_fn_mut(&mut self, _: &mut syn::ItemFn) {}

    fn visit_local_mut(&mut self, it: &mut syn::Local) {
        loops::hand_on(it);
        visit_mut::visit_local_mut(self, it);
    }

    /// Keeps loop attributes for the walk.
    fn visit_expr_mut(&mut self, it: &mut syn::Expr) {
        loops::without(it, |it| visit_mut::visit_expr_mut(self, it));
    }

    fn visit_type_reference_mut(&mut self, ty: &mut syn::TypeReference) {
        visit_mut::visit_type_reference_mut(self, ty);
        ty.lifetime = is_name(ty).then(|| syn::Lifetime::new("'static", ty.and_token.span));
    }

    fn visit_generic_argument_mut(&mut self, argument: &mut syn::GenericArgument) {
        visit_mut::visit_generic_argument_mut(self, argument);
        if let syn::GenericArgument::Lifetime(it) = argument {
            *it = syn::Lifetime::new("'_", it.apostrophe);
        }
    }

    fn visit_receiver_mut(&mut self, receiver: &mut syn::Receiver) {
        visit_mut::visit_receiver_mut(self, receiver);
        if let syn::ReceiverKind::Reference(_, lifetime, _) = &mut receiver.kind {
            *lifetime = None;
        }
    }
}
