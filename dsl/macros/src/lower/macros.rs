//! Macros, and the module `mem`, that are taken for Rust's by their names: rustc is asked whether they are.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::{Lowering, text};

impl Lowering<'_> {
    /// Whether a path may be that of a macro of Rust's; where it stands alone, rustc is asked.
    pub(super) fn is_rusts(&mut self, path: &syn::Path) -> bool {
        let Some(ident) = path.get_ident() else {
            let first = path.segments.first().map(|first| text(&first.ident));
            return path.segments.len() == 2 && matches!(first.as_deref(), Some("core" | "std"));
        };
        self.ask(ident);
        true
    }

    /// Lets rustc be asked whether a name is Rust's own.
    pub(super) fn ask(&mut self, name: &syn::Ident) {
        if !self.macros.contains(name) {
            self.macros.push(name.clone());
        }
    }
}

/// Calls that rustc finds ambiguous if a name is a macro of the author's own: one that stands above in the text
/// beside the import of Rust's, one that the module has or imports beside Rust's own.
pub fn asked(name: &syn::Ident) -> TokenStream {
    let arguments = match text(name).as_str() {
        "assert" => quote! { true },
        "assert_eq" | "matches" => quote! { 0, 0 },
        "assert_ne" => quote! { 0, 1 },
        _ => quote! {},
    };
    let module = format_ident!("__own_{}", text(name));
    if ["mem", "cmp"].contains(&text(name).as_str()) {
        return own_module(name, &module);
    }
    quote! {
        {
            use ::core::#name;
            let _ = || { #name!(#arguments); loop {} };
        }
        mod #module {
            use super::*;
            fn call() { let _ = || { #name!(#arguments); loop {} }; }
        }
    }
}

/// The same for a module of Rust's: a name that two globs bring is ambiguous unless both mean one thing.
fn own_module(name: &syn::Ident, module: &syn::Ident) -> TokenStream {
    quote! {
        mod #module {
            mod rusts {
                pub use ::core::#name;
            }
            #[allow(unused_imports)]
            use super::*;
            use rusts::*;
            use self::#name as asked;
        }
    }
}
