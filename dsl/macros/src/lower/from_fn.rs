//! Arrays that a closure fills, `core::array::from_fn(|i| …)`: a loop over their indices.

use bessemer_ir::tree::{self, ExprKind, Order, Start};

use super::closure::{closure_of, closure_parameter};
use super::made::plain;
use super::names::text;
use super::walk::Lowering;

impl Lowering<'_> {
    /// `core::array::from_fn(|i| …)`.
    pub(super) fn array_from_fn(&mut self, it: &mut syn::ExprCall) -> Option<ExprKind> {
        let syn::Expr::Path(function) = &*it.func else { return None };
        let mut segments = function.path.segments.iter().rev();
        let last = segments.next()?.ident.clone();
        if last != "from_fn" || segments.next()?.ident != "array" || it.args.len() != 1 {
            return None;
        }
        let closure = closure_of(&mut it.args[0])?;
        self.scoped(|walk| {
            let pattern = closure.inputs.first()?;
            let (index, looks) = match pattern {
                syn::Pat::Wild(_) => (walk.hidden("i"), Vec::new()),
                other => {
                    let (name, slot) = (closure_parameter(other)?, walk.slot());
                    (walk.bind_apart(&text(&name)), vec![walk.look(slot, &name)])
                }
            };
            let value = walk.closure_body(closure, looks);
            let name = walk.hidden("elements");
            let local = |name: &str| Box::new(plain(ExprKind::Local(name.to_owned()), &last));
            let element = Box::new(plain(ExprKind::Index(local(&name), local(&index)), &last));
            let assign = plain(ExprKind::Assign(None, element, Box::new(value)), &last);
            // The loop goes through what it fills.
            let array = *local(&name);
            let pattern = tree::Pattern::Any;
            let part = tree::Part { pattern, array, owned: false, group: None, reversed: false };
            let body = tree::Block { stmts: vec![tree::Stmt::Expr(assign)], tail: None };
            let each = ExprKind::Each {
                label: None,
                index: Some(index),
                parts: vec![part],
                order: Order::Up,
                cuts: Vec::new(),
                body,
            };
            let each = Box::new(plain(each, &last));
            Some(ExprKind::Fold { name, start: Start::Elements, each })
        })
    }
}
