//! Chains of several loops that are one: `rows.iter().flat_map(…)`, `a.iter().map(…).chain(b)`.
//!
//! In the tree each loop but the outermost is a part of what stands around it ([`ExprKind::Joined`](bessemer_ir::tree::ExprKind)).
//!
//! Invariant: the items of a part have names or are values before another link takes them, which stands within all loops.

use bessemer_ir::tree;

use super::flow::{Flow, Item, Over, Step, Takes};
use super::generator::named_item;
use super::item::ITEM;
use super::refuse;
use super::walk::Lowering;

impl Lowering<'_> {
    /// `.flat_map(|row| …)`: a loop in each pass of another.
    pub(super) fn nested(
        &mut self,
        mut outer: Flow,
        closure: &mut syn::ExprClosure,
    ) -> Option<Flow> {
        self.check_closure(closure);
        closure.capture = None;
        let before = self.scopes.last().map_or(0, Vec::len);
        let mut looks = Vec::new();
        self.name_item(&mut outer, (closure.inputs.first_mut()?, Takes::Items), &mut looks)?;
        let mut stmts = match &mut *closure.body {
            syn::Expr::Block(it) if it.label.is_none() => std::mem::take(&mut it.block.stmts),
            other => vec![syn::Stmt::Expr(other.clone(), None)],
        };
        self.iterators_with_names(&mut stmts);
        let Some(syn::Stmt::Expr(mut items, None)) = stmts.pop() else { return None };
        // What comes behind stands within these, and means other names.
        let apart = self.apart.replace("");
        let tree::Block { stmts: first, tail } = self.statements(&mut stmts);
        self.apart = apart;
        let first = first.into_iter().chain(tail.map(|tail| tree::Stmt::Expr(*tail)));
        outer.steps.extend(first.map(Step::Do));
        let named = named_item(&items);
        let mut inner = self.flow(&mut items)?;
        self.named_items(&mut inner, named, &mut items)?;
        if let Item::Leading(value) = &inner.item {
            let value = value.clone();
            let (name, _) = self.optional_name(&mut inner, (value, true), &mut items);
            inner.item = Item::Named(name);
        }
        stmts.push(syn::Stmt::Expr(items, None));
        // It gives what borrows its names, unless they are moved: that is the original's to say.
        *closure.body = syn::parse_quote! { { __unreached(); #(#looks)* #(#stmts)* } };
        for (name, _) in self.scopes.last_mut()?.iter_mut().skip(before) {
            name.clear();
        }
        if !inner.is_part() {
            return None;
        }
        let item = std::mem::replace(&mut inner.item, Item::Taken);
        Some(Flow { item, ..Flow::of_two(Over::Nested, [outer, inner]) })
    }

    /// `.chain(…)` of what is more than the elements of an array: two loops, whose items have one name, and the slot of its type.
    pub(super) fn both(&mut self, it: &mut syn::ExprMethodCall) -> Option<(Flow, u32)> {
        // It is made before the first loop begins.
        if !self.stays(&it.args[0]) {
            self.refusals.add(&it.args[0], refuse::CHAINED_LATER);
            return None;
        }
        let (name, slot) = (self.hidden(ITEM), self.slot());
        let mut named = |expr: &mut syn::Expr| {
            let parts = named_item(expr);
            let mut flow = self.flow(expr)?;
            let value = self.handed_value(&mut flow, parts, expr)?;
            let (name, site) = (name.clone(), flow.site);
            flow.steps.push(Step::Do(tree::Stmt::Let { name, slot, value: Some(value), site }));
            flow.is_part().then_some(flow)
        };
        let both = [named(&mut it.receiver)?, named(&mut it.args[0])?];
        Some((Flow { item: Item::Named(name), ..Flow::of_two(Over::Both, both) }, slot))
    }
}
