//! Views of matrices that are written: in the copy a call that writes the part.
//!
//! `m.column_mut(j).copy_from(&v)` becomes `m.set_column(j, &v)`, `m.fixed_view_mut::<2, 2>(i, j).scale_mut(s)` the
//! write of the product. What is read by `m.column(j)` is a value, and needs nothing here.

use quote::format_ident;

/// The views that may be written, without their `_mut`.
const VIEWS: [&str; 5] = ["row", "column", "fixed_view", "fixed_rows", "fixed_columns"];

/// A view that is written: `m.column_mut(j)`; the name without `_mut`.
fn written(expr: &mut syn::Expr) -> Option<(&mut syn::ExprMethodCall, String)> {
    match expr {
        syn::Expr::Paren(it) => written(&mut it.expr),
        syn::Expr::MethodCall(it) => {
            let name = super::text(&it.method);
            let name = name.strip_suffix("_mut")?.to_owned();
            VIEWS.contains(&name.as_str()).then_some((it, name))
        }
        _ => None,
    }
}

/// Methods of matrices that change each element, and take no value from the view.
const CHANGES: [&str; 8] = [
    "fill",
    "fill_diagonal",
    "fill_with_identity",
    "add_scalar_mut",
    "neg_mut",
    "component_mul_assign",
    "component_div_assign",
    "axpy",
];

/// What an expression that writes a view stands for.
pub(super) fn write(expr: &mut syn::Expr) -> Option<syn::Expr> {
    match expr {
        syn::Expr::MethodCall(it) => {
            let (method, arguments) = (super::text(&it.method), it.args.clone());
            let (view, name) = written(&mut it.receiver)?;
            let first = arguments.first().cloned();
            match (method.as_str(), first) {
                ("copy_from", Some(part)) if arguments.len() == 1 => Some(set(view, &name, part)),
                ("scale_mut" | "unscale_mut", Some(factor)) if arguments.len() == 1 => {
                    let read = read(view, &name);
                    let change = format_ident!("{}", method.strip_suffix("_mut")?);
                    Some(set(view, &name, syn::parse_quote! { &#read.#change(#factor) }))
                }
                ("fill", Some(value)) if name == "row" || name == "column" => {
                    let mut call = view.clone();
                    call.method = format_ident!("fill_{name}", span = view.method.span());
                    call.args.push(value);
                    Some(syn::Expr::MethodCall(call))
                }
                (method, _) if CHANGES.contains(&method) => {
                    let read = read(view, &name);
                    let change = format_ident!("{method}");
                    let set = set(view, &name, syn::parse_quote! { &part });
                    Some(syn::parse_quote! {
                        { let mut part = #read.into_owned(); part.#change(#arguments); #set; }
                    })
                }
                _ => None,
            }
        }
        _ => None,
    }
}

/// The view, as it is read.
fn read(view: &syn::ExprMethodCall, name: &str) -> syn::ExprMethodCall {
    let mut read = view.clone();
    read.method = format_ident!("{name}", span = view.method.span());
    read
}

fn set(view: &syn::ExprMethodCall, name: &str, part: syn::Expr) -> syn::Expr {
    let mut call = view.clone();
    call.method = format_ident!("set_{name}", span = view.method.span());
    call.args.push(part);
    syn::Expr::MethodCall(call)
}
