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

/// The call that an expression which writes a view stands for.
pub(super) fn write(expr: &mut syn::Expr) -> Option<syn::ExprMethodCall> {
    match expr {
        syn::Expr::MethodCall(it) if it.args.len() == 1 => {
            let (method, argument) = (super::text(&it.method), it.args.first()?.clone());
            let (view, name) = written(&mut it.receiver)?;
            match method.as_str() {
                "copy_from" => Some(set(view, &name, argument)),
                "scale_mut" | "unscale_mut" => {
                    let mut read = view.clone();
                    read.method = format_ident!("{name}", span = view.method.span());
                    let change = format_ident!("{}", method.strip_suffix("_mut")?);
                    Some(set(view, &name, syn::parse_quote! { &#read.#change(#argument) }))
                }
                "fill" if name == "row" || name == "column" => {
                    let mut call = view.clone();
                    call.method = format_ident!("fill_{name}", span = view.method.span());
                    call.args.push(argument);
                    Some(call)
                }
                _ => None,
            }
        }
        _ => None,
    }
}

fn set(view: &syn::ExprMethodCall, name: &str, part: syn::Expr) -> syn::ExprMethodCall {
    let mut call = view.clone();
    call.method = format_ident!("set_{name}", span = view.method.span());
    call.args.push(part);
    call
}
