//! The columns or the rows of a matrix, one after another: by their indices, in the tree and in the copy.
//!
//! `for c in m.column_iter() { … }` becomes `for column in 0..m.ncols() { let c = m.column(column); … }`; with
//! `.enumerate()` the counter has the author's name. A closure behind them is taken as a `for` is. What pairs them with
//! something else is no chain of a range's, and is refused where it stands.

use syn::{parse_quote, parse_quote_spanned};

use super::link::Link;
use super::names::text;
use super::view::may_repeat;
use super::walk::Lowering;

/// `m.column_iter()` with the links behind it, the first of them first.
struct Lines<'a> {
    call: &'a syn::ExprMethodCall,
    count: syn::Ident,
    line: syn::Ident,
    links: Vec<&'a syn::ExprMethodCall>,
}

impl<'a> Lines<'a> {
    /// None if an expression is something else, or computes its matrix.
    fn of(expr: &'a syn::Expr) -> Option<Lines<'a>> {
        let syn::Expr::MethodCall(call) = expr else { return None };
        if is_between(call) {
            let mut lines = Lines::of(&call.receiver)?;
            lines.links.push(call);
            let alone = lines.links.len() == 1;
            return (alone || !lines.links.iter().any(|link| counts(link))).then_some(lines);
        }
        let (count, line) = match text(&call.method).as_str() {
            "column_iter" => ("ncols", "column"),
            "row_iter" => ("nrows", "row"),
            "column_iter_mut" => ("ncols", "column_mut"),
            "row_iter_mut" => ("nrows", "row_mut"),
            _ => return None,
        };
        if !call.args.is_empty() || !may_repeat(&call.receiver) {
            return None;
        }
        let [count, line] = [count, line].map(|name| syn::Ident::new(name, call.method.span()));
        Some(Lines { call, count, line, links: Vec::new() })
    }

    fn are_written(&self) -> bool {
        text(&self.line).ends_with("_mut")
    }

    /// Whether the only link counts the lines, as their indices do.
    fn are_counted(&self) -> bool {
        matches!(self.links.as_slice(), [link] if counts(link))
    }

    /// The indices in their place, with the same links behind.
    fn indices(&self) -> syn::Expr {
        let (matrix, count, span) = (&self.call.receiver, &self.count, self.call.method.span());
        let range: syn::Expr = parse_quote_spanned! { span => 0..#matrix.#count() };
        if self.links.is_empty() || self.are_counted() {
            return range;
        }
        let mut chain: syn::Expr = parse_quote_spanned! { span => (#range) };
        for link in &self.links {
            let mut link = (*link).clone();
            *link.receiver = chain;
            chain = syn::Expr::MethodCall(link);
        }
        chain
    }

    /// Puts the index into a pattern in place of the line: `let` gives the line the author's name then.
    fn named(&self, pattern: &mut syn::Pat, fresh: &syn::Ident) -> Option<syn::Stmt> {
        let (matrix, line) = (&self.call.receiver, &self.line);
        let (index, name) = match pattern {
            syn::Pat::Tuple(pair) if self.are_counted() && pair.elems.len() == 2 => {
                let index = match &pair.elems[0] {
                    syn::Pat::Ident(own) if own.mutability.is_none() => own.ident.clone(),
                    syn::Pat::Wild(_) => fresh.clone(),
                    _ => return None,
                };
                (index, pair.elems[1].clone())
            }
            _ if self.are_counted() => return None,
            ref name => (fresh.clone(), (**name).clone()),
        };
        *pattern = parse_quote! { #index };
        Some(parse_quote! { let #name = #matrix.#line(#index); })
    }
}

impl Lowering<'_> {
    /// The loop over indices that a loop over lines stands for; none if it is another.
    pub(super) fn through_lines(&self, it: &syn::ExprForLoop) -> Option<syn::ExprForLoop> {
        let lines = Lines::of(&it.expr)?;
        let index = self.index_of(&lines, &syn::Expr::ForLoop(it.clone()));
        let (mut pat, mut body) = (it.pat.clone(), it.body.clone());
        body.stmts.insert(0, lines.named(&mut pat, &index)?);
        Some(syn::ExprForLoop { pat, expr: Box::new(lines.indices()), body, ..it.clone() })
    }

    /// The chain over indices that `m.column_iter().map(…)` stands for; none if a chain begins with something else.
    pub(super) fn chained_lines(&self, it: &syn::ExprMethodCall) -> Option<syn::ExprMethodCall> {
        let Some(lines) = Lines::of(&it.receiver) else {
            let syn::Expr::MethodCall(before) = &*it.receiver else { return None };
            let receiver = Box::new(syn::Expr::MethodCall(self.chained_lines(before)?));
            return Some(syn::ExprMethodCall { receiver, ..it.clone() });
        };
        let apart = matches!(Link::of(it), Some(Link::Zip | Link::Take));
        if is_between(it) || apart || lines.are_written() {
            return None;
        }
        let index = self.index_of(&lines, &syn::Expr::MethodCall(it.clone()));
        let mut taken = it.clone();
        let (indices, span) = (lines.indices(), it.method.span());
        let (matrix, line) = (&lines.call.receiver, &lines.line);
        let line: syn::Expr = parse_quote_spanned! { span => #matrix.#line(#index) };
        let item = if lines.are_counted() {
            parse_quote! { (#index, #line) }
        } else {
            line
        };
        *taken.receiver = parse_quote_spanned! { span => (#indices).map(|#index| #item) };
        Some(taken)
    }

    fn index_of(&self, lines: &Lines, whole: &syn::Expr) -> syn::Ident {
        self.fresh_in(text(&lines.line).trim_end_matches("_mut"), whole)
    }
}

/// Whether a link may stand between the lines and their consumer.
fn is_between(call: &syn::ExprMethodCall) -> bool {
    matches!(Link::of(call), Some(Link::Enumerate | Link::Rev | Link::StepBy))
}

fn counts(call: &syn::ExprMethodCall) -> bool {
    Link::of(call) == Some(Link::Enumerate)
}
