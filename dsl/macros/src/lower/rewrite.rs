//! Methods that are replaced by other code, in the tree and in the copy: `range.contains(&x)`, `values.get(a..b)`.
//!
//! The generated names are not in scope otherwise, so they do not capture the author's.

use quote::{format_ident, quote, quote_spanned};
use syn::parse_quote;
use syn::spanned::Spanned;

use super::names::text;
use super::pattern::by_let;
use super::sort::Leg;
use super::syntax::{bare, fresh, is_plain, names};
use super::walk::Lowering;
use super::{macros, sort};
use crate::numeric;
use crate::owned::{MADE, ONCE, by_method, is_of_nalgebra};

/// Modules of core whose functions have companions, and these functions.
const OF_CORE: [(&str, &[&str]); 4] =
    [("array", &["from_fn"]), ("cmp", &["max", "min"]), MADE, ("mem", &["swap", "replace"])];

impl Lowering {
    /// Returns the replacement of an expression; none if it has none.
    pub(super) fn rewritten(&mut self, expr: &syn::Expr) -> Option<syn::Expr> {
        let it = match expr {
            syn::Expr::MethodCall(it) => it,
            syn::Expr::Call(it) => {
                if let syn::Expr::Closure(_) = bare(&it.func) {
                    return Some(self.called_at_once(it));
                }
                let syn::Expr::Path(function) = &*it.func else { return None };
                let Some(method) =
                    by_method(it, numeric::is_of_num_traits).or_else(|| numeric::by_method(it))
                else {
                    return self.of_core(it);
                };
                if is_of_nalgebra(&function.path) {
                    self.ask_home(&function.path);
                }
                return Some(method);
            }
            syn::Expr::Range(it) if is_held(it) => return held(expr),
            syn::Expr::Assign(it) => return by_let(it),
            // rustc has computed it in the original.
            syn::Expr::Const(syn::ExprConst { block, .. }) => return Some(parse_quote! { #block }),
            syn::Expr::Macro(it) => {
                let stands_for = macros::expanded(&it.mac);
                if stands_for.is_some() {
                    self.is_rusts(&it.mac.path);
                }
                return stands_for;
            }
            _ => return None,
        };
        match (text(&it.method).as_str(), it.args.len()) {
            ("contains", 1) => self.contained(it),
            ("get" | "get_mut", 1) | ("copy_within", 2) => by_ends(it),
            _ => sort::sorted(it, Leg::Tree),
        }
    }

    /// Replaces `core::mem::swap(&mut a, &mut b)`, `core::cmp::max(a, b)` and the like by calls of companions, and
    /// `iter::once(x)` by an array with one element.
    fn of_core(&mut self, it: &syn::ExprCall) -> Option<syn::Expr> {
        let syn::Expr::Path(syn::ExprPath { path, .. }) = &*it.func else { return None };
        if is_once(it) {
            self.ask_home(path);
            let one = &it.args;
            return Some(parse_quote! { [#one].into_iter() });
        }
        let (home, name) = macros::in_module(path)?;
        let name = text(name);
        let (module, functions) = OF_CORE.into_iter().find(|(module, _)| home == module)?;
        let mut arguments = it.args.clone();
        let name = match name.as_str() {
            "take" => {
                arguments.push(parse_quote! { Default::default() });
                "replace"
            }
            name => name,
        };
        if !functions.contains(&name) {
            return None;
        }
        self.ask_home(path);
        let span = it.func.span();
        let [module, name] = [module, name].map(|it| syn::Ident::new(it, span));
        let turbofish = &path.segments.last()?.arguments;
        let path = quote_spanned! { span => ::bessemer::generate::#module::#name #turbofish };
        Some(parse_quote! { #path(#arguments) })
    }

    /// Replaces `(|x| …)(value)` by a closure with a name, and its call.
    fn called_at_once(&self, it: &syn::ExprCall) -> syn::Expr {
        let called = fresh("called", |name| self.is_local(name) || names(it, name));
        let (closure, arguments) = (bare(&it.func), &it.args);
        parse_quote! { { let mut #called = #closure; #called(#arguments) } }
    }

    /// Replaces `(a..b).contains(&x)` by comparisons.
    fn contained(&mut self, it: &syn::ExprMethodCall) -> Option<syn::Expr> {
        let fresh = |name: &str| fresh(name, |name| self.is_local(name) || names(it, name));
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
        let below = match range.limits {
            syn::RangeLimits::HalfOpen(_) => quote! { < },
            syn::RangeLimits::Closed(_) => quote! { <= },
        };
        let low = low.map(|low| quote! { #low <= #value });
        let high = high.map(|high| quote! { #value #below #high });
        let inside: Vec<_> = low.into_iter().chain(high).collect();
        Some(match names.is_empty() {
            _ if inside.is_empty() => return None,
            true => parse_quote! { (#(#inside)&&*) },
            false => parse_quote! { { #(#names)* (#(#inside)&&*) } },
        })
    }
}

/// Returns true for a call of `iter::once`.
pub(super) fn is_once(it: &syn::ExprCall) -> bool {
    let syn::Expr::Path(syn::ExprPath { path, .. }) = &*it.func else { return false };
    macros::in_module(path).is_some_and(|(home, name)| home == ONCE.0 && name == ONCE.1)
}

/// Returns true if evaluating `value` may change what `end` reads: it mentions the same variable.
fn may_change(value: &syn::Expr, end: &syn::Expr) -> bool {
    !is_plain(value) && root(end).is_some_and(|root| names(value, &text(root)))
}

/// Returns the variable that a plain expression is, or is a part of.
fn root(expr: &syn::Expr) -> Option<&syn::Ident> {
    match bare(expr) {
        syn::Expr::Path(it) => it.path.get_ident(),
        syn::Expr::Field(it) => root(&it.base),
        syn::Expr::Reference(it) => root(&it.expr),
        syn::Expr::Unary(it) => root(&it.expr),
        _ => None,
    }
}

/// Replaces the range in `values.get(a..b)` or `values.copy_within(a..b, place)` by its ends, since a range is no
/// value.
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

/// Returns `start..end` or `first..=last` as a value of Rust's range type.
pub(super) fn held(expr: &syn::Expr) -> Option<syn::Expr> {
    let syn::Expr::Range(it) = bare(expr) else { return None };
    let (start, end) = (it.start.as_ref()?, it.end.as_ref()?);
    Some(match it.limits {
        syn::RangeLimits::Closed(_) => {
            parse_quote! { ::bessemer::generate::RangeInclusive::new(#start, #end) }
        }
        syn::RangeLimits::HalfOpen(_) => {
            parse_quote! { ::core::ops::Range { start: #start, end: #end } }
        }
    })
}

/// Returns true if a range is always a value: an inclusive one, or one of floats, over which no loop iterates.
fn is_held(it: &syn::ExprRange) -> bool {
    let ends = [&it.start, &it.end].into_iter().flatten();
    matches!(it.limits, syn::RangeLimits::Closed(_)) || ends.map(|end| &**end).any(is_float)
}

/// Returns true if an expression is a float literal.
fn is_float(expr: &syn::Expr) -> bool {
    match bare(expr) {
        syn::Expr::Unary(syn::ExprUnary { op: syn::UnOp::Neg(_), expr, .. }) => is_float(expr),
        syn::Expr::Lit(it) => matches!(it.lit, syn::Lit::Float(_)),
        _ => false,
    }
}
