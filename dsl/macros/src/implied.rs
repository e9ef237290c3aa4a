//! Items of generic types' instances that are called other than by name: `[…]`, `==`, and the author's own `next` and
//! `iter`.
//!
//! Nobody knows all instances, and a generic type does not know what its implementations ask of its parameters. So an
//! instance is asked wherever it is built, by its definition, by its methods and by its name; one of these knows the bounds.

use bessemer_tree::{ITER, ITER_MUT};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::generics::Scope;

/// The statement of a builder that asks the type `owner`.
pub fn ask(owner: &TokenStream) -> TokenStream {
    quote! {
        {
            ::bessemer::generate::note_implied!(::bessemer::generate::Asked::<#owner>::of(), __cx);
        }
    }
}

/// The answer of a generic type: `build` builds the function of the trait `of`, for an operand of type `other`.
pub fn noted(
    of: &syn::Ident,
    (owner, other): (&syn::Type, &syn::Type),
    (scope, bound): (Scope<'_>, Option<TokenStream>),
    build: &TokenStream,
) -> TokenStream {
    let (declared, bounds, name) = (scope.declared(), scope.value_bounds(bound), of.to_string());
    quote! {
        #[allow(private_bounds)]
        impl #declared ::bessemer::generate::OwnImplied<::bessemer::generate::sign::#of> for #owner #bounds {
            fn note(__cx: &mut ::bessemer::generate::Builder) {
                __cx.implied::<Self, #other>(#name, #build);
            }
        }
    }
}

/// The sign of a method that loops call by no name.
pub fn sign_of(method: &str) -> Option<syn::Ident> {
    match method {
        ITER => Some(format_ident!("Iter")),
        ITER_MUT => Some(format_ident!("IterMut")),
        _ => None,
    }
}
