//! `#[derive(Default)]` of a struct with arrays of any length. Rust's own derive takes lengths up to 32 alone, so below an
//! attribute of the DSL the implementation is written out where a field is an array that may be longer.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::punctuated::Punctuated;

use crate::generics::Scope;

/// The longest array of which Rust has a default.
const LONGEST: u64 = 32;

type Traits = Punctuated<syn::Path, syn::Token![,]>;

/// Takes `Default` out of the derived traits of a struct with such an array, and returns its implementation.
pub fn of_arrays(it: &mut syn::ItemStruct) -> Option<TokenStream> {
    it.fields.iter().find(|field| is_long(&field.ty))?;
    let mut derived = false;
    for attribute in it.attrs.iter_mut().filter(|it| it.path().is_ident("derive")) {
        let Ok(traits) = attribute.parse_args_with(Traits::parse_terminated) else { continue };
        let is_default =
            |of: &syn::Path| of.segments.last().is_some_and(|last| last.ident == "Default");
        let rest: Vec<_> = traits.iter().filter(|of| !is_default(of)).collect();
        if rest.len() < traits.len() {
            derived = true;
            *attribute = syn::parse_quote!(#[derive(#(#rest),*)]);
        }
    }
    if !derived {
        return None;
    }
    let scope = Scope::of_type(&it.generics);
    let (name, declared, arguments) = (&it.ident, scope.declared(), scope.applied());
    let bounds = scope.bounds(scope.types().map(|ty| quote! { #ty: ::core::default::Default }));
    let fields = it.fields.iter().zip(it.fields.members()).map(|(field, member)| {
        let value = value(&field.ty);
        quote! { #member: #value }
    });
    Some(quote! {
        #[automatically_derived]
        #[allow(private_bounds)]
        impl #declared ::core::default::Default for #name #arguments #bounds {
            fn default() -> Self {
                Self { #(#fields),* }
            }
        }
    })
}

/// Returns true if a type is an array that may have more elements than [`LONGEST`].
fn is_long(ty: &syn::Type) -> bool {
    let syn::Type::Array(it) = ty else { return false };
    let short = match &it.len {
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Int(len), .. }) => {
            len.base10_parse::<u64>().is_ok_and(|len| len <= LONGEST)
        }
        _ => false,
    };
    !short || is_long(&it.elem)
}

fn value(ty: &syn::Type) -> TokenStream {
    match ty {
        syn::Type::Array(it) => {
            let element = value(&it.elem);
            quote! { ::core::array::from_fn(|_| #element) }
        }
        ty => {
            let ty = ty.to_token_stream();
            quote! { <#ty as ::core::default::Default>::default() }
        }
    }
}
