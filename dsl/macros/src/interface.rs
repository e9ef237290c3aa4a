//! Expands interfaces: annotated traits, and their implementations.
//!
//! In a generation build a trait has two hidden items for each method: the companion, and the builder. An
//! implementation defines the builders of its own methods, and the trait those of methods with a default.

use bessemer_tree::Role;
use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::spanned::Spanned;

use crate::attributes::{self, Asked};
use crate::builder::{self, Home, Subject};
use crate::closures;
use crate::generics::{Scope, conversion};
use crate::imports;
use crate::instance;
use crate::kind::Kind;
use crate::lower::{self, Refusals, refuse};
use crate::numeric;
use crate::operators;
use crate::own_numbers;
use crate::place;
use crate::redirect;

/// Expands `#[interface]`.
pub fn expand(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let mut refusals = Refusals::default();
    if !arguments.is_empty() {
        refusals.add(&arguments, refuse::ARGUMENTS);
    }
    let mut it = match syn::parse2::<syn::ItemTrait>(item.clone()) {
        Ok(it) => it,
        Err(_) => {
            refusals.add(refuse::first_token(&item), refuse::NOT_A_TRAIT);
            let errors = refusals.into_tokens();
            return quote! { #errors #item };
        }
    };
    lower::check_attributes(&it.attrs, &mut refusals);
    if lower::generating() {
        // Each type of the DSL has a size.
        for param in it.generics.type_params_mut() {
            let bounds = std::mem::take(&mut param.bounds).into_iter();
            param.bounds = bounds.filter(|bound| !closures::is_relaxed(bound)).collect();
        }
    }
    let named = syn::Path::from(it.ident.clone());
    if operators::known(&named).is_some() || refuse::known_trait(&named).is_some() {
        refusals.add(&it.ident, refuse::RUST_TRAIT);
    }
    let beside = interface(&mut it, &mut refusals);
    let errors = refusals.into_tokens();
    quote! { #errors #it #beside }
}

/// Adds the hidden items to the trait, and returns the markers of its methods.
fn interface(it: &mut syn::ItemTrait, refusals: &mut Refusals) -> TokenStream {
    let (name, generics) = (it.ident.clone(), it.generics.clone());
    let (mut hidden, mut beside) = (Vec::new(), TokenStream::new());
    // Who has the interface has what its supertraits have, by the DSL's names.
    let implied = numeric::implied_by(&it.supertraits, lower::generating());
    it.supertraits.extend(implied);
    if lower::generating() {
        let asked = it.supertraits.iter().filter_map(conversion);
        let asked = asked.flat_map(|(of, other)| of.predicates(&quote! { Self }, other));
        let asked: Vec<syn::WherePredicate> = asked.map(|it| syn::parse_quote!(#it)).collect();
        for predicate in asked {
            match predicate {
                // A bound on the interface requires this, too.
                syn::WherePredicate::Type(of_self) if is_self(&of_self.bounded_ty) => {
                    it.supertraits.extend(of_self.bounds);
                }
                other => it.generics.make_where_clause().predicates.push(other),
            }
        }
    }
    for item in &mut it.items {
        match item {
            syn::TraitItem::Fn(method) => {
                let mut refusals = Refusals::default();
                if let Some(body) = &mut method.default {
                    imports::write_out(&method.sig, body);
                }
                hidden.extend(own_numbers::alias(method));
                let asked = attributes::of_interface(method, &mut refusals);
                let parts = Method { interface: &name, generics: &generics, method, asked };
                if let Some((inside, marker)) = parts.expand(&mut refusals) {
                    hidden.extend(inside);
                    beside.extend(marker);
                }
                native(method, refusals, &mut hidden, &generics);
            }
            syn::TraitItem::Const(_) => {}
            syn::TraitItem::Type(it) if it.generics.params.is_empty() => {
                if lower::generating() {
                    it.colon_token.get_or_insert_default();
                    it.bounds.push(syn::parse_quote!(::bessemer::generate::Value));
                }
            }
            other => refusals.add(refuse::first_token(other), refuse::INTERFACE_ITEM),
        }
    }
    // Implementations request it: a trait without the attribute is reported in every build. It tells the module, since another may
    // have an interface of this name.
    hidden.push(syn::parse_quote! {
        #[doc(hidden)]
        fn __marked_interface() -> &'static str where Self: Sized { ::core::module_path!() }
    });
    it.items.extend(hidden);
    beside
}

/// Returns true if a type is `Self`.
fn is_self(ty: &syn::Type) -> bool {
    matches!(ty, syn::Type::Path(it) if it.path.is_ident("Self"))
}

/// Returns the native method.
fn native(
    method: &mut syn::TraitItemFn,
    refusals: Refusals,
    hidden: &mut Vec<syn::TraitItem>,
    generics: &syn::Generics,
) {
    match &mut method.default {
        Some(body) => {
            let scope = Scope::of_type(generics).with_method(&method.sig.generics);
            redirect::native((&mut method.attrs, body), scope, refusals);
        }
        None if refusals.is_empty() => {}
        None => {
            let errors = refusals.into_tokens();
            let refused = format_ident!("__refused_{}", lower::text(&method.sig.ident));
            hidden.push(syn::parse_quote! {
                #[doc(hidden)]
                fn #refused() where Self: Sized { #errors }
            });
        }
    }
}

/// A method of an interface.
struct Method<'a> {
    interface: &'a syn::Ident,
    generics: &'a syn::Generics,
    method: &'a syn::TraitItemFn,
    asked: Asked,
}

impl Method<'_> {
    /// Returns the hidden items of the trait, and the marker beside it.
    fn expand(self, refusals: &mut Refusals) -> Option<(Vec<syn::TraitItem>, TokenStream)> {
        let Method { interface, generics, method, asked } = self;
        let (signature, empty) = (&method.sig, syn::parse_quote!({}));
        let subject = Subject {
            attributes: &method.attrs,
            visibility: &syn::Visibility::Inherited,
            signature,
            body: method.default.as_ref().unwrap_or(&empty),
            asked,
            home: Home::Interface(interface),
        };
        let scope = Scope::of_type(generics).with_method(&signature.generics);
        let mut parts = builder::lower(&subject, scope, refusals)?;
        let name = &signature.ident;
        if own_numbers::is_borrowed(signature) {
            parts.parameters[0] = quote! { &self };
        }
        let marker = format_ident!("__{}_{}", interface, lower::text(name));
        let arguments = scope.arguments_of_self();
        let clause = scope.own().bounds([quote! { Self: Sized }]);
        let called = (&quote! { #marker #arguments }, &clause);
        let companion = builder::companion(&subject, &lower::companion_name(name), called, &parts);
        let build = builder::build_name(name);
        let build_item = if method.default.is_some() {
            syn::parse2(parts.builder).ok()?
        } else {
            let (declared, bounds) =
                (scope.own().declared(), builder::build_bounds(&subject, scope));
            let told = format!("{interface}::{}", lower::text(name));
            let site = place::site(name);
            syn::parse_quote! {
                #[doc(hidden)]
                fn #build #declared(__cx: &mut ::bessemer::generate::Builder) -> ::bessemer::generate::tree::Callee
                #bounds
                {
                    __cx.unmarked::<Self>(#told, ::core::file!(), #site)
                }
            }
        };
        let trait_arguments = scope.outer().applied();
        let this = syn::parse_quote!(__S: #interface #trait_arguments);
        let open = scope.with_implementor(&this);
        let declared = builder::declare_marker(&marker, open);
        let owner = quote! { <__S as #interface #trait_arguments> };
        let callee = builder::callee(&owner, &marker, open, None, name);
        let beside = quote! { #declared const _: () = { #callee }; };
        Some((vec![syn::parse_quote!(#companion), build_item], beside))
    }
}

/// Returns the native `impl` block of an interface, and the items beside it.
pub fn implementation(
    kind: Kind,
    mut it: syn::ItemImpl,
    refusals: &mut Refusals,
) -> (TokenStream, TokenStream) {
    let Some((path, _)) = it.trait_.clone() else { return Default::default() };
    if let Some(known) = operators::known(&path) {
        return operators::implementation(kind, known, it, refusals);
    }
    if numeric::is_own(&path) {
        return operators::of_number(kind, it, refusals);
    }
    if let Some(reason) = refuse::known_trait(&path) {
        refusals.add(&path, reason);
        return (it.into_token_stream(), TokenStream::new());
    }
    if matches!(*it.self_ty, syn::Type::Reference(_)) {
        refusals.add(&it.self_ty, refuse::FOREIGN_IMPLEMENTATION);
        return (it.into_token_stream(), TokenStream::new());
    }
    let mut hidden: Vec<syn::ImplItem> = Vec::new();
    let (mut builds, mut faces) = (Vec::new(), Vec::new());
    own_numbers::by_methods(&mut it);
    for item in &mut it.items {
        let method = match item {
            syn::ImplItem::Fn(method) => method,
            syn::ImplItem::Const(_) | syn::ImplItem::Type(_) => continue,
            other => {
                refusals.add(refuse::first_token(other), refuse::IMPL_ITEM);
                continue;
            }
        };
        let mut refusals = Refusals::default();
        let asked = attributes::of_method(kind, method, &mut refusals);
        let role = asked.role;
        let subject = Subject::of(method, asked, Home::Implementation(&path));
        let scope = Scope::of_type(&it.generics).with_method(&method.sig.generics);
        let build = builder::build_name(&method.sig.ident);
        if let Some(parts) = builder::lower(&subject, scope, &mut refusals) {
            hidden.extend(syn::parse2(parts.builder).ok());
            if !scope.own().is_generic() {
                builds.push((method.sig.ident.clone(), build.clone()));
            }
        }
        if matches!(role, Role::Entry { .. }) && !scope.own().is_generic() {
            faces.push(build);
        }
        redirect::native((&mut method.attrs, &mut method.block), scope, refusals);
    }
    it.items.extend(hidden);
    let scope = Scope::of_type(&it.generics);
    let mut beside = marked(scope, &it.self_ty, &path);
    beside.extend(instance::block(&it, &faces));
    if !scope.is_generic() {
        let (owner, path) = (lower::lasting_type(&it.self_ty), lower::lasting_path(&path));
        beside.extend(builds.iter().map(|(name, build)| {
            let build = quote! { Function(<#owner as #path>::#build) };
            let registered = place::registered(name, &build);
            quote! { const _: () = { #registered }; }
        }));
    } else if lower::generating() {
        let values = scope.values_beside(&path).map(|it| syn::parse_quote!(#it));
        let values: Vec<syn::WherePredicate> = values.collect();
        it.generics.make_where_clause().predicates.extend(values);
    }
    (it.into_token_stream(), beside)
}

/// Returns code that compiles only if the trait is an interface.
fn marked(scope: Scope<'_>, owner: &syn::Type, path: &syn::Path) -> TokenStream {
    let (declared, bounds) = match lower::generating() {
        true => (scope.declared(), scope.value_bounds([])),
        false => (scope.declared(), scope.bounds([])),
    };
    // Told at the name of the trait.
    let ask = quote_spanned! { path.span() => <#owner as #path>::__marked_interface() };
    quote! {
        const _: () = {
            #[allow(dead_code)]
            fn ask #declared() #bounds { #ask; }
        };
    }
}
