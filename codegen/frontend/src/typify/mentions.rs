//! Uses of an iterator in a function: one that is used once needs no count of its items, and only some need an end.
//!
//! Invariant: the number may be too large, never too small. An iterator without a count begins anew at each use.

use bessemer_ir::tree::visit::{Visit, walk_expr, walk_stmt};
use bessemer_ir::tree::{self, Builtin, Desugared, ExprKind as Tree, Source, Stmt};

use super::syntax::bare;
use crate::standard;

/// Visitor that counts the uses of a name. A use in a loop counts twice, and so does a `let` that binds the iterator
/// to a second name.
struct Mentions<'n> {
    name: &'n str,
    depth: usize,
    /// Number of the name's `let`.
    declared: usize,
    /// Number of `let`s with the name: if there are several, its meaning is ambiguous.
    lets: usize,
    count: usize,
}

/// Returns the number of uses of the iterator called `name`; 2 represents every number above 1.
pub(super) fn mentions(name: &str, body: &tree::Block) -> usize {
    let mut mentions = Mentions { name, depth: 0, declared: 0, lets: 0, count: 0 };
    mentions.block(body);
    if mentions.lets > 1 { mentions.count.max(2) } else { mentions.count }
}

/// Returns true if an expression of a function takes items of an iterator from its end. These are `bytes.next_back()`, and a loop
/// over `bytes.by_ref().rev()`.
pub(super) fn takes_from_end<'f>(
    name: &str,
    expr: &tree::Expr,
    (function, known): (&tree::Function, &impl Fn(&str) -> Option<&'f tree::Function>),
) -> bool {
    let is_it = |of: &tree::Expr| matches!(&bare(of).kind, Tree::Local(it) if it == name);
    let callee = |callee: u32| function.callees.get(callee as usize);
    let is_borrowed = |of: &tree::Expr| match &of.kind {
        Tree::Ref(true, of) => is_it(of),
        Tree::Call(by_ref, arguments) => {
            let by_ref = matches!(
                callee(*by_ref),
                Some(tree::Callee::Builtin(Builtin::Desugared(Desugared::ByRef)))
            );
            by_ref && arguments.iter().any(is_it)
        }
        _ => false,
    };
    match &expr.kind {
        Tree::Call(called, arguments) => {
            let called = match callee(*called) {
                Some(tree::Callee::Function(path)) => known(path.as_str()),
                _ => None,
            };
            called.is_some_and(|it| match standard::is_rev(it) {
                true => arguments.iter().any(is_borrowed),
                false => standard::is_next_back(it) && arguments.iter().any(is_it),
            })
        }
        Tree::Each { source, .. } => source.any(&|it| match it {
            Source::Rev(of) => {
                matches!(&**of, Source::Elements(of, _) if is_borrowed(of))
            }
            _ => false,
        }),
        _ => false,
    }
}

impl Mentions<'_> {
    /// Returns true if an expression is the name, or a mutable borrow of it: `&mut bytes`, `bytes.by_ref()`.
    fn is_it(&self, expr: &tree::Expr) -> bool {
        match &expr.kind {
            Tree::Local(name) => name == self.name,
            Tree::Ref(true, of) | Tree::Deref(of) => self.is_it(of),
            // Only `by_ref` returns its receiver. Any other call of one argument is counted twice, which does no harm.
            Tree::Call(_, arguments) => matches!(&arguments[..], [of] if self.is_it(of)),
            _ => false,
        }
    }
}

impl Visit for Mentions<'_> {
    fn stmt(&mut self, stmt: &Stmt) {
        walk_stmt(self, stmt);
        if let Stmt::Let { name, value, .. } = stmt {
            self.count += usize::from(value.as_ref().is_some_and(|value| self.is_it(value)));
            if name == self.name {
                self.lets += 1;
                self.declared = self.depth;
            }
        }
    }

    fn expr(&mut self, expr: &tree::Expr) {
        use Tree::{Closure, Each, While};
        match &expr.kind {
            Tree::Local(name) if name == self.name => {
                self.count += if self.depth > self.declared { 2 } else { 1 };
            }
            Each { .. } | While { .. } | Closure(_) => {
                self.depth += 1;
                walk_expr(self, expr);
                self.depth -= 1;
            }
            _ => walk_expr(self, expr),
        }
    }
}
