//! `#[data]` on a `const` or a `static`: a constant with C attributes.
//!
//! Code that uses it needs no mark, since a constant is identified by name, type and value. The mark only registers
//! its attributes.

use bessemer_tree::attributes::Given;
use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens, quote};

use crate::given::{self, On};
use crate::lower::{self, Refusals, refuse};
use crate::{docs, expression, place};

/// Returns the items beside a `const`.
pub fn constant(it: &mut syn::ItemConst, refusals: &mut Refusals) -> TokenStream {
    if it.ident == "_" {
        refusals.add(&it.ident, refuse::TABLE_UNNAMED);
    }
    announced((&it.ident, &it.vis, &it.expr), &mut it.attrs, refusals)
}

/// Returns the items beside a `static`.
pub fn fixed(it: &mut syn::ItemStatic, refusals: &mut Refusals) -> TokenStream {
    if let syn::StaticMutability::Mut(token) = &it.mutability {
        refusals.add(token, refuse::STATIC);
    }
    announced((&it.ident, &it.vis, &it.expr), &mut it.attrs, refusals)
}

fn announced(
    (name, visibility, value): (&syn::Ident, &syn::Visibility, &syn::Expr),
    attributes: &mut Vec<syn::Attribute>,
    refusals: &mut Refusals,
) -> TokenStream {
    lower::check_attributes(attributes, refusals);
    let hexadecimal = is_hexadecimal(value.to_token_stream());
    let expression = expression::told(value);
    let given = Given { hexadecimal, expression, ..given::read(attributes, On::Table, refusals) };
    given::strip(attributes);
    if !refusals.is_empty() || !lower::generating() {
        return TokenStream::new();
    }
    let (docs, given) = (docs::lines(attributes), given::tokens(&given));
    let public = matches!(visibility, syn::Visibility::Public(_));
    let (place, named, site) = (place::place(), place::named(name), place::site(name));
    quote! {
        const _: () = {
            ::bessemer::generate::register! {
                ::bessemer::generate::Registered::table(#place, #site, |__cx| {
                    __cx.table(#named, &[#(#docs),*], #site, &#name, #public, #given);
                })
            }
        };
    }
}

/// Returns true if a value contains hexadecimal literals.
fn is_hexadecimal(value: TokenStream) -> bool {
    value.into_iter().any(|token| match token {
        TokenTree::Literal(it) => it.to_string().starts_with("0x"),
        TokenTree::Group(it) => is_hexadecimal(it.stream()),
        _ => false,
    })
}
