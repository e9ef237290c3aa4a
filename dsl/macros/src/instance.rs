//! Instances of generic types with an author's name, which are in the C.

use proc_macro2::TokenStream;
use quote::quote;

use crate::builder;
use crate::docs;
use crate::generics::Scope;
use crate::given::{self, On};
use crate::implied;
use crate::lower::{self, Refusals, refuse};
use crate::place;

/// Returns the methods of a named instance that are in the C: those of a generic block, by the names of their
/// builders. Two such blocks would be ambiguous.
pub fn one_block(it: &syn::ItemImpl, faces: &[syn::Ident]) -> TokenStream {
    let scope = Scope::of_type(&it.generics);
    if !scope.is_generic() || faces.is_empty() {
        return TokenStream::new();
    }
    let (declared, owner) = (scope.declared(), &it.self_ty);
    let bounds = match lower::generating() {
        true => scope.value_bounds(builder::owner_bound(scope, &quote! { #owner })),
        false => scope.bounds([]),
    };
    let build = lower::generating().then(|| {
        quote! {
            fn build(__cx: &mut ::bessemer::generate::Builder) {
                #(Self::#faces(__cx);)*
            }
        }
    });
    let of = match scope.is_for_all(owner) {
        true => quote! { EntriesInOneBlock },
        false => quote! { EntriesOfSomeInstances },
    };
    quote! {
        impl #declared ::bessemer::#of for #owner #bounds { #build }
    }
}

/// Expands `#[data] pub type PidF32 = Pid<f32>;`, which names an instance and so makes it part of the C.
pub fn named(it: &syn::ItemType, refusals: &mut Refusals) -> TokenStream {
    for parameter in &it.generics.params {
        refusals.add(parameter, refuse::GENERIC_ALIAS);
    }
    lower::check_attributes(&it.attrs, refusals);
    lower::check_field(&it.ty, refusals);
    let given = given::tokens(&given::read(&it.attrs, On::Type, refusals));
    if !refusals.is_empty() || !lower::generating() {
        return TokenStream::new();
    }
    let (name, docs) = (&it.ident, docs::lines(&it.attrs));
    let (named, site) = (place::named(name), place::site(name));
    let implied = implied::ask(&quote! { #name });
    let registered = place::registered(
        name,
        &quote! {
            Other(|__cx| {
                #[allow(unused_imports)]
                use ::bessemer::generate::WithoutEntries as _;
                __cx.alias::<#name>(#named, &[#(#docs),*], #site, #given);
                #implied
                let instance = ::bessemer::generate::Instance::<#name>::new();
                instance.build_entries(__cx);
                instance.build_further_entries(__cx);
            })
        },
    );
    quote! { const _: () = { #registered }; }
}
