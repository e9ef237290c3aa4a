//! Place of an item: its module, and the folder of its package. By the folder, generation recognises a crate that
//! another workspace has built into the same target folder.
//!
//! The folder is said as the file system knows it: a package that two workspaces reach by links is one package to cargo,
//! built once, and a link may be gone when it is used.

use std::path::PathBuf;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::lower;

/// A `bessemer::generate::Place`.
pub fn place() -> TokenStream {
    let named = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let folder = named.canonicalize().unwrap_or(named);
    let folder = Literal::string(&folder.to_string_lossy());
    quote!((::core::module_path!(), #folder))
}

/// Line and column of a name, as builders take them.
pub fn site(name: &syn::Ident) -> TokenStream {
    let lower::Site(line, column) = lower::site(name);
    quote!((#line, #column))
}

/// The item that announces to its package what has a `name`, and how it is built: a `bessemer::generate::Build`.
pub fn registered(name: &syn::Ident, build: &TokenStream) -> TokenStream {
    let (place, site) = (place(), site(name));
    quote! {
        ::bessemer::generate::register! {
            ::bessemer::generate::Registered::new(#place, #site, ::bessemer::generate::Build::#build)
        }
    }
}

/// A `bessemer::generate::Named`.
pub fn named(name: &syn::Ident) -> TokenStream {
    let name = lower::text(name);
    quote! {
        ::bessemer::generate::Named { module: ::core::module_path!(), file: ::core::file!(), name: #name }
    }
}
