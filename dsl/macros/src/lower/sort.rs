//! Replaces calls such as `values.sort_by_key(|x| …)`. Simulation and C use the DSL's own routine, since another one
//! might order equal elements differently.

use quote::ToTokens;
use syn::spanned::Spanned;
use syn::{parse_quote, parse_quote_spanned};

use super::names::text;
use super::syntax::{fresh, names};

/// Destination of the replacement.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Leg {
    /// Native item, which the simulation runs.
    Native,
    /// Tree and witness copy.
    Tree,
}

/// Returns the replacement of a call; none if it does not sort, or has an unknown comparison.
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

/// Kind of a sort's closure.
enum By {
    Key,
    Comparison,
}

/// Returns the closure that compares or returns the key, or one that calls the passed function.
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

/// Returns two names that some syntax does not contain.
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
    // rustc reports a value that is no `Ordering` at the closure.
    parse_quote_spanned! { body.span() => |#inputs| { #body }.is_lt() }
}
