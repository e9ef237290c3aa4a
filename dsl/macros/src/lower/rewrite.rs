//! Methods that stand for other code: `range.contains(&x)`, `values.get(a..b)`. In the tree and in the copy that code stands
//! in their place.
//!
//! Its names are those of nothing in scope, so that no name of the author's changes their meaning.

use proc_macro2::Span;
use quote::{format_ident, quote_spanned};
use syn::parse_quote;

use super::names::text;
use super::pattern::by_let;
use super::sort::Leg;
use super::syntax::{bare, is_plain, names};
use super::walk::Lowering;
use super::{macros, refuse, sort};

/// The modules of core whose functions have companions, and these functions.
const OF_CORE: [(&str, [&str; 2]); 2] = [("mem", ["swap", "replace"]), ("cmp", ["max", "min"])];

impl Lowering<'_> {
    /// The expansion of an expression; none if it stands for itself.
    pub(super) fn rewritten(&mut self, expr: &syn::Expr) -> Option<syn::Expr> {
        let it = match expr {
            syn::Expr::MethodCall(it) => it,
            syn::Expr::Call(it) => return self.of_core(it),
            syn::Expr::Range(it) => return held(it),
            syn::Expr::Assign(it) => return by_let(it),
            // rustc has computed it in the original.
            syn::Expr::Const(syn::ExprConst { block, .. }) => return Some(parse_quote! { #block }),
            syn::Expr::Macro(it) => {
                if it.mac.path.is_ident(macros::MATCHES) {
                    self.is_rusts(&it.mac.path);
                }
                return macros::expanded(&it.mac);
            }
            _ => return None,
        };
        match (text(&it.method).as_str(), it.args.len()) {
            ("contains", 1) => self.contained(it),
            ("get" | "get_mut", 1) | ("copy_within", 2) => by_ends(it),
            _ => {
                let sorted = sort::sorted(it, Leg::Tree);
                if sorted.is_none() && sort::sorts(it) {
                    self.refusals.add(&it.method, refuse::SORTING);
                }
                sorted
            }
        }
    }

    /// `core::mem::swap(&mut a, &mut b)`, `core::cmp::max(a, b)`: by the companions that these have.
    fn of_core(&mut self, it: &syn::ExprCall) -> Option<syn::Expr> {
        let span = syn::spanned::Spanned::span(&it.func);
        let mut arguments = it.args.clone();
        for (module, names) in OF_CORE {
            let Some(name) = self.function_of(module, it) else { continue };
            let name = match name.as_str() {
                "take" => {
                    arguments.push(parse_quote! { Default::default() });
                    "replace"
                }
                name => name,
            };
            if !names.contains(&name) {
                return None;
            }
            let [module, name] = [module, name].map(|it| syn::Ident::new(it, span));
            let path = quote_spanned! { span => ::bessemer::generate::#module::#name };
            return Some(parse_quote! { #path(#arguments) });
        }
        None
    }

    /// The name of what is called, if that is a function of Rust's `module` by its path.
    fn function_of(&mut self, module: &str, it: &syn::ExprCall) -> Option<String> {
        let syn::Expr::Path(function) = &*it.func else { return None };
        let segments = &function.path.segments;
        let names: Vec<_> = segments.iter().map(|part| text(&part.ident)).collect();
        let names: Vec<_> = names.iter().map(String::as_str).collect();
        let (home, name) = match names.as_slice() {
            [_, home, name] if refuse::library(&function.path).is_some() => (home, name),
            [home, name] => (home, name),
            _ => return None,
        };
        if *home != module {
            return None;
        }
        if names.len() == 2 {
            self.ask(&segments[0].ident);
        }
        Some((*name).to_owned())
    }

    /// A name that nothing has here, nor in `beside`.
    pub(super) fn fresh_beside(&self, name: &str, beside: &syn::ExprMethodCall) -> syn::Ident {
        self.fresh_in(name, &syn::Expr::MethodCall(beside.clone()))
    }

    pub(super) fn fresh_in(&self, name: &str, beside: &syn::Expr) -> syn::Ident {
        let mut fresh = name.to_owned();
        while self.is_local(&fresh) || names(beside, &fresh) {
            fresh.push('_');
        }
        syn::Ident::new(&fresh, Span::call_site())
    }

    /// `(a..b).contains(&x)`: the comparisons.
    fn contained(&mut self, it: &syn::ExprMethodCall) -> Option<syn::Expr> {
        let fresh = |name: &str| self.fresh_beside(name, it);
        let syn::Expr::Range(range) = bare(&it.receiver) else { return None };
        let value = match &it.args[0] {
            syn::Expr::Reference(it) if it.mutability.is_none() => (*it.expr).clone(),
            other => parse_quote! { *#other },
        };
        let mut names: Vec<syn::Stmt> = Vec::new();
        let ends = [&range.start, &range.end].map(|end| end.as_deref().cloned());
        // An end is read before the value is computed, which may change it.
        let stays = |end: &syn::Expr| is_plain(end) && !may_change(&value, end);
        let all_plain = ends.iter().flatten().all(stays);
        let mut named = |name: syn::Ident, expr: syn::Expr| -> syn::Expr {
            names.push(parse_quote! { let #name = #expr; });
            parse_quote! { #name }
        };
        let [low, high] = match ends {
            ends if all_plain => ends,
            [low, high] => [
                low.map(|low| named(fresh("low"), low)),
                high.map(|high| named(fresh("high"), high)),
            ],
        };
        let value = match low.is_none() || high.is_none() || is_plain(&value) {
            true => value,
            false => named(fresh("value"), value),
        };
        let above = low.map(|low| -> syn::Expr {
            parse_quote! { #low <= #value }
        });
        let below = high.map(|high| -> syn::Expr {
            match range.limits {
                syn::RangeLimits::HalfOpen(_) => parse_quote! { #value < #high },
                syn::RangeLimits::Closed(_) => parse_quote! { #value <= #high },
            }
        });
        let inside: syn::Expr = match (above, below) {
            (Some(above), Some(below)) => parse_quote! { (#above && #below) },
            (one, other) => one.or(other).map(|it| parse_quote! { (#it) })?,
        };
        Some(match names.is_empty() {
            true => inside,
            false => parse_quote! { { #(#names)* #inside } },
        })
    }
}

/// Whether computing `value` may change what `end` reads: whoever writes a variable names it.
fn may_change(value: &syn::Expr, end: &syn::Expr) -> bool {
    !is_plain(value) && root(end).is_some_and(|root| names(value, &root.to_string()))
}

/// The variable that a plain expression is, or is a part of.
fn root(expr: &syn::Expr) -> Option<&syn::Ident> {
    match bare(expr) {
        syn::Expr::Path(it) => it.path.get_ident(),
        syn::Expr::Field(it) => root(&it.base),
        syn::Expr::Reference(it) => root(&it.expr),
        syn::Expr::Unary(it) => root(&it.expr),
        _ => None,
    }
}

/// `values.get(a..b)`, `values.copy_within(a..b, place)`: by its ends, since a range is no value.
fn by_ends(it: &syn::ExprMethodCall) -> Option<syn::Expr> {
    let syn::Expr::Range(range) = bare(&it.args[0]) else { return None };
    let from = match &range.start {
        Some(from) => (**from).clone(),
        None => parse_quote! { 0 },
    };
    let to: Option<syn::Expr> = range.end.as_ref().map(|to| match range.limits {
        syn::RangeLimits::HalfOpen(_) => (**to).clone(),
        // Nothing ends behind the last index that there could be.
        syn::RangeLimits::Closed(_) => parse_quote! { usize::saturating_add(#to, 1) },
    });
    let mut call = it.clone();
    call.method = match to {
        Some(_) => format_ident!("slice_{}_part", it.method, span = it.method.span()),
        None => format_ident!("slice_{}_rest", it.method, span = it.method.span()),
    };
    call.args = [from].into_iter().chain(to).chain(it.args.iter().skip(1).cloned()).collect();
    Some(syn::Expr::MethodCall(call))
}

/// `first..=last` as a value: what Rust makes of it.
fn held(it: &syn::ExprRange) -> Option<syn::Expr> {
    let (start, end) = (it.start.as_ref()?, it.end.as_ref()?);
    let closed = matches!(it.limits, syn::RangeLimits::Closed(_));
    closed.then(|| parse_quote! { ::bessemer::generate::RangeInclusive::new(#start, #end) })
}
