//! `for` over the columns or the rows of a matrix: a `for` over their indices, in the tree and in the copy.
//!
//! `for c in m.column_iter() { … }` becomes `for column in 0..m.ncols() { let c = m.column(column); … }`; with
//! `.enumerate()` the counter has the author's name.

use syn::parse_quote;

use super::view::may_repeat;
use super::{Lowering, text};

impl Lowering<'_> {
    /// The loop over indices that such a loop stands for; none if it is another, or computes its matrix.
    pub(super) fn through_lines(&self, it: &syn::ExprForLoop) -> Option<syn::ExprForLoop> {
        let (lines, counted) = match &*it.expr {
            syn::Expr::MethodCall(call) if call.method == "enumerate" && call.args.is_empty() => {
                (&*call.receiver, true)
            }
            other => (other, false),
        };
        let syn::Expr::MethodCall(lines) = lines else { return None };
        let (count, line) = match text(&lines.method).as_str() {
            "column_iter" => ("ncols", "column"),
            "row_iter" => ("nrows", "row"),
            "column_iter_mut" => ("ncols", "column_mut"),
            "row_iter_mut" => ("nrows", "row_mut"),
            _ => return None,
        };
        let matrix = &lines.receiver;
        if !lines.args.is_empty() || !may_repeat(matrix) {
            return None;
        }
        let whole = syn::Expr::ForLoop(it.clone());
        let index = self.fresh_in(line.trim_end_matches("_mut"), &whole);
        let (counter, name): (syn::Pat, &syn::Pat) = match (&*it.pat, counted) {
            (syn::Pat::Tuple(pair), true) if pair.elems.len() == 2 => {
                (pair.elems[0].clone(), &pair.elems[1])
            }
            (_, true) => return None,
            (name, false) => (parse_quote! { #index }, name),
        };
        let [count, line] = [count, line].map(|name| syn::Ident::new(name, lines.method.span()));
        let mut body = it.body.clone();
        let index = match &counter {
            syn::Pat::Ident(own) if own.mutability.is_none() => &own.ident,
            syn::Pat::Wild(_) => &index,
            _ => return None,
        };
        body.stmts.insert(0, parse_quote! { let #name = #matrix.#line(#index); });
        let range = parse_quote! { 0..#matrix.#count() };
        Some(syn::ExprForLoop {
            pat: parse_quote! { #index },
            expr: Box::new(range),
            body,
            ..it.clone()
        })
    }

    /// `m.column_iter().map(…)`: the columns, by their indices; none if a chain begins with something else.
    pub(super) fn chained_lines(&self, expr: &syn::Expr) -> Option<syn::Expr> {
        let syn::Expr::MethodCall(it) = expr else { return None };
        let (count, line) = match text(&it.method).as_str() {
            "column_iter" => ("ncols", "column"),
            "row_iter" => ("nrows", "row"),
            _ => {
                let mut chain = it.clone();
                *chain.receiver = self.chained_lines(&it.receiver)?;
                return Some(syn::Expr::MethodCall(chain));
            }
        };
        let matrix = &it.receiver;
        if !it.args.is_empty() || !may_repeat(matrix) {
            return None;
        }
        let index = self.fresh_in(line, expr);
        let [count, line] = [count, line].map(|name| syn::Ident::new(name, it.method.span()));
        Some(parse_quote! { (0..#matrix.#count()).map(|#index| #matrix.#line(#index)) })
    }
}
