//! Instances of generic types with an author's name, which are in the C.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use proc_macro2::TokenStream;
use quote::quote;

use crate::builder;
use crate::docs;
use crate::generics::Scope;
use crate::given::{self, On};
use crate::implied;
use crate::lower::{self, Refusals, refuse};
use crate::place;

/// Number of blocks of one type whose methods a named instance has.
const BLOCKS: usize = 16;

/// Returns the number of a block among those of types of its name. rustc expands the attributes of a crate one after
/// the other, in one process; beyond the last number it reports two blocks of one number.
fn number(owner: &syn::Type) -> usize {
    static COUNTS: Mutex<BTreeMap<String, usize>> = Mutex::new(BTreeMap::new());
    let mut counts = COUNTS.lock().unwrap_or_else(PoisonError::into_inner);
    let name = lower::last_ident(owner).map(lower::text).unwrap_or_default();
    let count = counts.entry(name).or_default();
    *count += 1;
    (*count - 1) % BLOCKS
}

/// Returns the methods of a named instance that are in the C: those of a generic type's block, by the names of their
/// builders.
pub fn block(it: &syn::ItemImpl, faces: &[syn::Ident]) -> TokenStream {
    let scope = Scope::of_type(&it.generics);
    if !lower::generating() || !scope.is_generic() || faces.is_empty() {
        return TokenStream::new();
    }
    let (declared, owner, number) = (scope.declared(), &it.self_ty, number(&it.self_ty));
    let bounds = scope.value_bounds(builder::owner_bound(scope, &quote! { #owner }));
    quote! {
        impl #declared ::bessemer::generate::EntriesOfBlock<#number> for #owner #bounds {
            fn build(__cx: &mut ::bessemer::generate::Builder) {
                #(Self::#faces(__cx);)*
            }
        }
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
    let (implied, blocks) = (implied::ask(&quote! { #name }), 0..BLOCKS);
    let registered = place::registered(
        name,
        &quote! {
            Other(|__cx| {
                #[allow(unused_imports)]
                use ::bessemer::generate::WithoutEntries as _;
                __cx.alias::<#name>(#named, &[#(#docs),*], #site, #given);
                #implied
                #(::bessemer::generate::Instance::<#name, #blocks>::new().build_entries(__cx);)*
            })
        },
    );
    quote! { const _: () = { #registered }; }
}
