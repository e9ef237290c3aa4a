//! Place of an item: its module, and the folder of its package. By the folder, generation detects a crate that
//! another workspace has built into the same target folder.
//!
//! The folder is canonical: cargo builds a package once that two workspaces reach by links, and a link may be gone
//! later.

use std::path::PathBuf;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::lower;

/// Returns a `bessemer::generate::Place`.
pub fn place() -> TokenStream {
    let named = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let folder = named.canonicalize().unwrap_or(named);
    let folder = Literal::string(&folder.to_string_lossy());
    quote!((::core::module_path!(), #folder))
}

/// Returns line and column of a name, for builders.
pub fn site(name: &syn::Ident) -> TokenStream {
    let lower::Site(line, column) = lower::site(name);
    quote!((#line, #column))
}

/// Returns the item that registers `name` with its package, and its `bessemer::generate::Build`.
pub fn registered(name: &syn::Ident, build: &TokenStream) -> TokenStream {
    let (place, site) = (place(), site(name));
    quote! {
        ::bessemer::generate::register! {
            ::bessemer::generate::Registered::new(#place, #site, ::bessemer::generate::Build::#build)
        }
    }
}

/// Returns the item that registers a generic item, of which only instances become C.
pub fn template(name: &syn::Ident, kind: &TokenStream) -> TokenStream {
    template_of(name, kind, &quote! { ::core::option::Option::None })
}

/// Returns the item that registers a method of a generic type.
pub fn generic_method(name: &syn::Ident, owner: &syn::Ident) -> TokenStream {
    let owner = lower::text(owner);
    template_of(name, &quote! { Method }, &quote! { ::core::option::Option::Some(#owner) })
}

fn template_of(name: &syn::Ident, kind: &TokenStream, owner: &TokenStream) -> TokenStream {
    let (named, site) = (named(name), site(name));
    let kind = quote! { ::bessemer::generate::tree::TemplateKind::#kind };
    registered(name, &quote! { Other(|__cx| __cx.template(#kind, #named, #site, #owner)) })
}

/// Returns a `bessemer::generate::Named`.
pub fn named(name: &syn::Ident) -> TokenStream {
    let name = lower::text(name);
    quote! {
        ::bessemer::generate::Named { module: ::core::module_path!(), file: ::core::file!(), name: #name }
    }
}
