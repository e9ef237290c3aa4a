//! Iterators as arguments, `mean(values.iter().filter(…))`, and parameters that take them.
//!
//! In the tree such an argument is a closure that hands each item to [`EACH`]: the loop of a chain, which stands where the
//! function goes through its parameter. In the witness copy it stays a chain.
//!
//! Invariant: what is handed on is looked at on its way, so that its type is known.

use bessemer_ir::tree::{self, EACH, ExprKind, NO_SLOT};
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::visit::Visit;
use syn::visit_mut::{self, VisitMut};

use super::flow::{Flow, Item, Takes};
use super::generator::named_item;
use super::made::{UNIT, plain};
use super::names::callee_name;
use super::signature::{Names, Parameter};
use super::walk::Lowering;
use super::{refuse, signature};

impl Lowering<'_> {
    /// An iterator as an argument.
    pub(super) fn items_argument(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        let (whole, before) = (expr.clone(), self.refusals.len());
        let handed = self.scoped(|walk| {
            let named = named_item(expr);
            let mut flow = walk.flow(expr)?;
            let value = walk.handed_value(&mut flow, named, expr)?;
            let last = tree::Stmt::Expr(plain(ExprKind::Apply(EACH.into(), vec![value]), &whole));
            let body = Box::new(plain(flow.into_loop(last, None), &whole));
            let (name, slot) = (EACH.to_owned(), NO_SLOT);
            let each = tree::Pattern::Name { name, slot, mutable: false, inner: None };
            Some(ExprKind::Closure(tree::Closure { name: None, parameters: vec![each], body }))
        });
        if handed.is_none() && self.refusals.len() == before {
            self.refusals.add(&whole, refuse::CHAIN);
        }
        plain(handed.unwrap_or(UNIT), &whole)
    }

    /// The items of a chain, as a value that may be handed on; `named`: a pattern for one, and what is made of its names.
    pub(super) fn handed_value(
        &mut self,
        flow: &mut Flow,
        named: (syn::Pat, syn::Expr),
        expr: &mut syn::Expr,
    ) -> Option<tree::Expr> {
        self.named_items(flow, named, expr)?;
        match &flow.item {
            pair @ Item::Pair(..) => Self::named_value(pair, &syn::Ident::new(EACH, expr.span())),
            _ => self.item_value(flow, expr),
        }
    }

    /// Gives the items of a chain names, unless they have some or are values.
    pub(super) fn named_items(
        &mut self,
        flow: &mut Flow,
        (mut pattern, value): (syn::Pat, syn::Expr),
        expr: &mut syn::Expr,
    ) -> Option<()> {
        if !matches!(flow.item, Item::Source(_) | Item::Number) {
            return Some(());
        }
        let mut looks = Vec::new();
        self.name_item(flow, (&mut pattern, Takes::Items), &mut looks)?;
        let items = &*expr;
        *expr = syn::Expr::Verbatim(quote_spanned! { items.span() =>
            ::core::iter::IntoIterator::into_iter(#items).map(|#pattern| { #(#looks)* #value })
        });
        Some(())
    }

    /// `items.collect()`: a call of the function of an author's that gathers them.
    pub(super) fn collected(&mut self, it: &mut syn::ExprMethodCall) -> ExprKind {
        let arguments = it.turbofish.as_ref().and_then(|it| it.args.first());
        let into = match arguments {
            Some(syn::GenericArgument::Type(ty)) => ty.clone(),
            _ => syn::parse_quote!(_),
        };
        signature::check_type(&into, self.refusals);
        let items = self.items_argument(&mut it.receiver);
        let callee = self.callees;
        self.callees += 1;
        let (slot, chain) = (callee_name(callee), &it.receiver);
        let of = quote! { ::bessemer::generate::FromIteratorBuiltin<_> };
        let call = quote_spanned! { it.method.span() => <#into as #of>::__b_from_iter(#chain) };
        *it = syn::parse_quote! { #slot.__take(#call) };
        ExprKind::Call(callee, vec![items])
    }
}

/// Writes out `.into_iter()` behind the parameters that are iterators, so that their chains show by their syntax.
pub fn as_iterators(parameters: &[Parameter], body: &mut syn::Block) {
    let mut bound = Vec::new();
    Names(&mut bound).visit_block(body);
    let items = parameters.iter().filter(|it| it.items && !bound.contains(&it.name));
    Iterators(items.map(|it| &it.ident).collect()).visit_block_mut(body);
}

struct Iterators<'a>(Vec<&'a syn::Ident>);

impl VisitMut for Iterators<'_> {
    fn visit_expr_method_call_mut(&mut self, it: &mut syn::ExprMethodCall) {
        visit_mut::visit_expr_method_call_mut(self, it);
        let receiver = &it.receiver;
        if let syn::Expr::Path(path) = &**receiver
            && self.0.iter().any(|name| path.path.is_ident(*name))
        {
            *it.receiver = syn::parse_quote! { #receiver.into_iter() };
        }
    }
}
