//! Calls such as `values.sort_by_key(|x| …)`. They use the DSL's own routine in the simulation and in the C, since
//! another one would order equal elements differently.

use quote::ToTokens;
use syn::spanned::Spanned;
use syn::{parse_quote, parse_quote_spanned};

use super::names::text;
use super::syntax::{fresh, names};

/// Leg of a comparison: in the native item, or in the tree and the witness copy.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Leg {
    /// The simulation.
    Native,
    /// The C.
    Tree,
}

/// The expansion of a call; none if it sorts nothing, or by no comparison that the DSL knows.
pub fn sorted(it: &syn::ExprMethodCall, leg: Leg) -> Option<syn::Expr> {
    let (by, closure) = sorting(it)?;
    let below: syn::Expr = match (by, closure.inputs.len()) {
        (By::Key, 1) => by_key(&closure, leg),
        (By::Comparison, 2) => by_comparison(&closure),
        _ => return None,
    };
    let (values, span) = (&it.receiver, it.method.span());
    let values: syn::Expr = parse_quote_spanned! { span => &mut #values[..] };
    Some(parse_quote! { ::bessemer::sort::sort_by(#values, #below) })
}

/// Criterion of a sort.
enum By {
    Key,
    Comparison,
}

/// The closure that compares, or gives the key; or that calls the function that does.
fn sorting(it: &syn::ExprMethodCall) -> Option<(By, syn::ExprClosure)> {
    let by = match text(&it.method).as_str() {
        "sort_by_key" | "sort_unstable_by_key" => By::Key,
        "sort_by" | "sort_unstable_by" => By::Comparison,
        _ => return None,
    };
    let closure = match it.args.first().filter(|_| it.args.len() == 1)? {
        // A type that is written for the result would be lost.
        syn::Expr::Closure(closure) if matches!(closure.output, syn::ReturnType::Default) => {
            closure.clone()
        }
        syn::Expr::Path(it) => {
            let [one, other] = two_beside(it);
            match by {
                By::Key => parse_quote! { |#one| #it(#one) },
                By::Comparison => parse_quote! { |#one, #other| #it(#one, #other) },
            }
        }
        _ => return None,
    };
    Some((by, closure))
}

/// Names for two elements that stand nowhere in what they are put beside.
fn two_beside(beside: &impl ToTokens) -> [syn::Ident; 2] {
    let is_taken = |name: &str| names(beside, name);
    [fresh("one", is_taken), fresh("other", is_taken)]
}

fn by_key(closure: &syn::ExprClosure, leg: Leg) -> syn::Expr {
    let (pattern, key) = (&closure.inputs[0], &closure.body);
    let [one, other] = two_beside(closure);
    match leg {
        // What has no order is reported where the key stands.
        Leg::Native => parse_quote_spanned! { key.span() => |#one, #other| {
            let (#one, #other) = ({ let #pattern = #one; #key }, { let #pattern = #other; #key });
            ::core::cmp::Ord::cmp(&#one, &#other).is_lt()
        } },
        Leg::Tree => parse_quote_spanned! { key.span() =>
            |#one, #other| { let #pattern = #one; #key } < { let #pattern = #other; #key }
        },
    }
}

fn by_comparison(closure: &syn::ExprClosure) -> syn::Expr {
    let (inputs, body) = (&closure.inputs, &closure.body);
    parse_quote! { |#inputs| { #body }.is_lt() }
}
