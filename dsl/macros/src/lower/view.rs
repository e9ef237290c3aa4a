//! Views of matrices that are written: in the copy a call that writes the part.
//!
//! `m.column_mut(j).copy_from(&v)` becomes `m.set_column(j, &v)`, `m.fixed_view_mut::<2, 2>(i, j).scale_mut(s)` the
//! write of the product. What is read by `m.column(j)` is a value, and needs nothing here.

use quote::{format_ident, quote_spanned};

use super::names::text;
use super::walk::Lowering;

/// The views that may be written, without their `_mut`.
const VIEWS: [&str; 5] = ["row", "column", "fixed_view", "fixed_rows", "fixed_columns"];

/// A view that is written: `m.column_mut(j)`; the name without `_mut`.
pub(super) fn written(expr: &mut syn::Expr) -> Option<(&mut syn::ExprMethodCall, String)> {
    match expr {
        syn::Expr::Paren(it) => written(&mut it.expr),
        syn::Expr::MethodCall(it) => {
            let name = text(&it.method);
            let name = name.strip_suffix("_mut")?.to_owned();
            VIEWS.contains(&name.as_str()).then_some((it, name))
        }
        _ => None,
    }
}

impl Lowering<'_> {
    /// The expansion of an expression that writes a view.
    pub(super) fn written_view(&self, expr: &syn::Expr) -> Option<syn::Expr> {
        let syn::Expr::MethodCall(it) = expr else { return None };
        let (method, arguments) = (text(&it.method), it.args.clone());
        let mut receiver = (*it.receiver).clone();
        let (view, name) = written(&mut receiver)?;
        let first = arguments.first().cloned();
        let mut names: Vec<syn::Stmt> = Vec::new();
        // Where the view lies is computed once.
        let mut once = || {
            let moves = !arguments.iter().all(may_repeat);
            if !may_repeat(&view.receiver) {
                let (matrix, place) = (self.fresh_beside("matrix", it), &view.receiver);
                names.push(syn::parse_quote! { let #matrix = &mut #place; });
                *view.receiver = syn::parse_quote! { #matrix };
            }
            for (at, name) in view.args.iter_mut().zip(["at", "beside"]) {
                if !may_repeat(at) || moves && !matches!(at, syn::Expr::Lit(_)) {
                    let name = self.fresh_beside(name, it);
                    names.push(syn::parse_quote! { let #name = #at; });
                    *at = syn::parse_quote! { #name };
                }
            }
        };
        let write: syn::Expr = match (method.as_str(), first) {
            ("copy_from", Some(part)) if arguments.len() == 1 => {
                if !cannot_fault(&part) {
                    once();
                    names.extend(inside(view, &name)?);
                }
                set(view, &name, part)
            }
            ("scale_mut" | "unscale_mut", Some(factor)) if arguments.len() == 1 => {
                once();
                let read = read(view, &name);
                let change = format_ident!("{}", method.strip_suffix("_mut")?);
                set(view, &name, syn::parse_quote! { &#read.#change(#factor) })
            }
            ("fill", Some(value)) if name == "row" || name == "column" => {
                if !cannot_fault(&value) {
                    once();
                    names.extend(inside(view, &name)?);
                }
                let mut call = view.clone();
                call.method = format_ident!("view_fill_{name}", span = view.method.span());
                call.args.push(value);
                syn::Expr::MethodCall(call)
            }
            _ => return None,
        };
        Some(match names.is_empty() {
            true => write,
            false => syn::parse_quote! { { #(#names)* #write; } },
        })
    }
}

/// Whether an expression comes to the same twice, and does nothing: arithmetic of names and numbers.
pub(super) fn may_repeat(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Index(it) => may_repeat(&it.expr) && may_repeat(&it.index),
        syn::Expr::Cast(it) => may_repeat(&it.expr),
        syn::Expr::Unary(it) => may_repeat(&it.expr),
        syn::Expr::Binary(it) => {
            super::expr::compound(&it.op).is_none() && may_repeat(&it.left) && may_repeat(&it.right)
        }
        _ => of_names(expr, may_repeat),
    }
}

/// Whether computing an expression can have no fault.
fn cannot_fault(expr: &syn::Expr) -> bool {
    of_names(expr, cannot_fault)
}

/// Whether an expression is a name, a number, or a part of one for which `inner` holds.
fn of_names(expr: &syn::Expr, inner: fn(&syn::Expr) -> bool) -> bool {
    match expr {
        syn::Expr::Lit(_) | syn::Expr::Path(_) => true,
        syn::Expr::Paren(it) => inner(&it.expr),
        syn::Expr::Field(it) => inner(&it.base),
        syn::Expr::Reference(it) => it.mutability.is_none() && inner(&it.expr),
        _ => false,
    }
}

/// The checks of where a view lies, which Rust makes before it computes what is written there; none if the
/// view does not say its size.
fn inside(view: &syn::ExprMethodCall, name: &str) -> Option<Vec<syn::Stmt>> {
    let one: syn::Expr = syn::parse_quote! { 1 };
    let mut sizes = view.turbofish.iter().flat_map(|it| &it.args);
    let mut size = || -> Option<syn::Expr> {
        match sizes.next()? {
            syn::GenericArgument::Const(it) => Some(it.clone()),
            syn::GenericArgument::Type(it) => Some(syn::parse_quote! { #it }),
            _ => None,
        }
    };
    let (rows, columns) = ("nrows", "ncols");
    let sides = match name {
        "row" => vec![(rows, one)],
        "column" => vec![(columns, one)],
        "fixed_rows" => vec![(rows, size()?)],
        "fixed_columns" => vec![(columns, size()?)],
        _ => vec![(rows, size()?), (columns, size()?)],
    };
    let matrix = &view.receiver;
    let checks = view.args.iter().zip(sides).map(|(at, (side, size))| {
        let side = format_ident!("{side}", span = view.method.span());
        let end = sum(at, &size).unwrap_or_else(|| syn::parse_quote! { #at + #size });
        let check = quote_spanned! { view.method.span() =>
           ::bessemer::__inside!(#end <= #matrix.#side());
        };
        syn::parse2(check).ok()
    });
    checks.collect()
}

/// The sum of two numbers that are written out.
fn sum(one: &syn::Expr, other: &syn::Expr) -> Option<syn::Expr> {
    let number = |expr: &syn::Expr| match expr {
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Int(it), .. }) => {
            it.base10_parse::<usize>().ok()
        }
        _ => None,
    };
    let sum = number(one)?.checked_add(number(other)?)?;
    let sum = proc_macro2::Literal::usize_suffixed(sum);
    Some(syn::parse_quote! { #sum })
}

/// The view, as it is read.
fn read(view: &syn::ExprMethodCall, name: &str) -> syn::ExprMethodCall {
    let mut read = view.clone();
    read.method = format_ident!("{name}", span = view.method.span());
    read
}

pub(super) fn set(view: &syn::ExprMethodCall, name: &str, part: syn::Expr) -> syn::Expr {
    let mut call = view.clone();
    call.method = format_ident!("set_{name}", span = view.method.span());
    call.args.push(part);
    syn::Expr::MethodCall(call)
}
