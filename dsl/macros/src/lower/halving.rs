//! `values.binary_search(&x)`, `values.partition_point(|x| …)` and the like: a call of the DSL's own routine, in the
//! simulation as in the C, since of equal elements core does not say which one it finds.

use syn::{parse_quote, parse_quote_spanned};

use super::names::text;
use super::syntax::names;

/// What a call stands for; none if it searches nothing.
pub fn searched(it: &syn::ExprMethodCall) -> Option<syn::Expr> {
    let values = &it.receiver;
    let arguments: Vec<_> = it.args.iter().collect();
    let span = it.method.span();
    let values: syn::Expr = parse_quote_spanned! { span => &#values[..] };
    match (text(&it.method).as_str(), arguments.as_slice()) {
        ("partition_point", [first @ syn::Expr::Closure(_)]) => {
            Some(parse_quote! { ::bessemer::search::partition_point(#values, #first) })
        }
        ("binary_search", [wanted]) => {
            let wanted: syn::Expr = match wanted {
                syn::Expr::Reference(it) => (*it.expr).clone(),
                other => parse_quote! { *#other },
            };
            Some(parse_quote! { ::bessemer::search::binary_search(#values, #wanted) })
        }
        ("binary_search_by", [order @ syn::Expr::Closure(_)]) => {
            Some(parse_quote! { ::bessemer::search::binary_search_by(#values, #order) })
        }
        ("binary_search_by_key", [wanted, syn::Expr::Closure(key)]) => {
            let mut name = "wanted".to_owned();
            while names(&syn::Expr::MethodCall(it.clone()), &name) {
                name.push('_');
            }
            let name = syn::Ident::new(&name, proc_macro2::Span::call_site());
            let (parameters, body) = (&key.inputs, &key.body);
            let order: syn::Expr = parse_quote! { |#parameters| { #body }.cmp(#name) };
            Some(parse_quote! {
                { let #name = #wanted; ::bessemer::search::binary_search_by(#values, #order) }
            })
        }
        _ => None,
    }
}
