//! What is gone through by its elements or numbers, where it is a value: `values.iter().rev()` before `.map(…)`, or as an
//! argument, `mean(values.iter().rev())`.
//!
//! In the tree it is a closure that hands each item to [`EACH`]: a loop, which stands where its taker goes through it. In
//! the witness copy it stays what it is, and its items are looked at on their way, so that their types are known.

use bessemer_ir::tree::{self, EACH, ExprKind, NO_SLOT};
use proc_macro2::Span;
use quote::quote_spanned;
use syn::parse_quote;
use syn::spanned::Spanned;

use super::generator::named_item;
use super::made::{UNIT, plain};
use super::walk::Lowering;

impl Lowering<'_> {
    /// The closure that hands on each item.
    pub(super) fn handing(&mut self, expr: &mut syn::Expr) -> ExprKind {
        let (whole, (pattern, item)) = (expr.clone(), named_item(expr));
        let each = syn::Ident::new(EACH, Span::call_site());
        let mut through: syn::ExprForLoop = parse_quote! { for #pattern in () { #each(#item); } };
        *through.expr = expr.clone();
        // Whatever stands in the place of handing it on means other names.
        let outer = self.apart.replace("");
        let body = self.scoped(|walk| walk.for_loop(&mut through));
        self.apart = outer;
        let syn::ExprForLoop { pat, expr: items, body: mut pass, .. } = through;
        if let Some(last) = pass.stmts.last_mut()
            && let syn::Stmt::Expr(syn::Expr::Call(call), _) = last
        {
            *last = syn::Stmt::Expr(call.args[0].clone(), None);
        }
        let stmts = &pass.stmts;
        *expr = syn::Expr::Verbatim(quote_spanned! { items.span() =>
            __items(::core::iter::IntoIterator::into_iter(#items).map(|#pat| { #(#stmts)* }))
        });
        let body = Box::new(plain(body.unwrap_or(UNIT), &whole));
        let (name, slot) = (EACH.to_owned(), NO_SLOT);
        let each = tree::Pattern::Name { name, slot, mutable: false, inner: None };
        ExprKind::Closure(tree::Closure { name: None, parameters: vec![each], body })
    }
}
