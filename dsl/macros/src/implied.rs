//! Functions of generic types' instances that have no call in the source: `Index`, `==`, and an author's `next` and
//! `iter`.
//!
//! No one knows all instances, and a generic type does not know the bounds of its implementations. So an instance is
//! queried wherever it is built: by its definition, by its methods and by its name; one of these has the bounds.

use bessemer_tree::{ITER, ITER_MUT};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::generics::Scope;

/// Returns the builder's statement that queries the type `owner`.
pub fn ask(owner: &TokenStream) -> TokenStream {
    quote! {
        {
            ::bessemer::generate::note_implied!(::bessemer::generate::Asked::<#owner>::of(), __cx);
        }
    }
}

/// Implements the answer for a generic type: `build` builds the function of the trait `of`, for an operand of type
/// `other`.
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

/// Returns the sign that identifies a method which loops call implicitly.
pub fn sign_of(method: &str) -> Option<syn::Ident> {
    match method {
        ITER => Some(format_ident!("Iter")),
        ITER_MUT => Some(format_ident!("IterMut")),
        _ => None,
    }
}
