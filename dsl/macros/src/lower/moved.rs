//! `move` closures, which use copies of the variables that may change.
//!
//! The copies are declared before the statement, or the closure body, in which the closure is written.
//!
//! Invariant: nothing else in that statement writes such a variable before the closure is made, so the copy has the value
//! that Rust copies. A closure for which this is not known is refused.

use bessemer_tree as tree;
use bessemer_tree::ExprKind;
use syn::visit::Visit;

use super::names::site;
use super::refuse;
use super::syntax::names;
use super::walk::{Lowering, Moved};
use super::written::{Named, Written};

impl Lowering {
    /// Begins a statement that writes these names, and those that the aliases in it may write. Returns the copies of the
    /// statement around it.
    pub(super) fn begin_copies(
        &mut self,
        mut written: Vec<String>,
        visit: impl FnOnce(&mut Named),
    ) -> Option<Moved> {
        written.extend(self.aliases.written_by(visit));
        let known = (self.scopes.len(), self.scopes.last().map_or(0, Vec::len));
        self.moved.replace(Moved { written, known, copies: Vec::new() })
    }

    /// Ends a statement, and returns the declarations of its copies.
    pub(super) fn end_copies(&mut self, outer: Option<Moved>) -> Vec<tree::Stmt> {
        std::mem::replace(&mut self.moved, outer).map(|it| it.copies).unwrap_or_default()
    }

    /// Lowers the body of a closure or of an arm, with the copies for `move` closures in it.
    pub(super) fn in_body(
        &mut self,
        body: &mut syn::Expr,
        lower: impl FnOnce(&mut Self, &mut syn::Expr) -> tree::Expr,
    ) -> tree::Expr {
        let outer = self.begin_copies(Written::of(|it| it.head(body)), |it| it.visit_expr(body));
        let mut value = lower(self, body);
        let stmts = self.end_copies(outer);
        if !stmts.is_empty() {
            let (site, slot) = (value.site, value.slot);
            let block = tree::Block { stmts, tail: Some(Box::new(value)) };
            value = tree::Expr { kind: ExprKind::Block(block), site, slot };
        }
        value
    }

    /// Lowers code that may run several times in a statement: nothing can be declared before its closures.
    pub(super) fn repeated<T>(&mut self, lower: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.moved.take();
        let lowered = lower(self);
        self.moved = outer;
        lowered
    }

    /// Declares copies before the present statement for a `move` closure in it, if they have the values that Rust copies.
    pub(super) fn copied_before(&mut self, closure: &mut syn::ExprClosure) {
        let captured = self.captured(closure);
        let known = |(written, known): (&[String], (usize, usize)), own: &String| {
            !written.contains(own) && self.is_bound_before(own, known)
        };
        let Some(moved) = &self.moved else { return };
        if !captured.iter().all(|own| known((&moved.written, moved.known), own)) {
            return;
        }
        let copies = self.copies(closure);
        if let Some(moved) = &mut self.moved {
            moved.copies.extend(copies);
        }
    }

    /// Declares a copy of each variable that a `move` closure captures and that may change, and binds its name in this
    /// scope to the copy.
    pub(super) fn copies(&mut self, closure: &mut syn::ExprClosure) -> Vec<tree::Stmt> {
        let captured = self.captured(closure);
        let Some(token) = closure.capture.take() else { return Vec::new() };
        let site = site(&token);
        let mut stmts = Vec::new();
        for own in captured {
            let Some(known) = self.local_name(&own).map(str::to_owned) else { continue };
            let mut name = self.hidden(&format!("{own}%"));
            // The scope of an earlier copy is closed, and its name is declared all the same.
            while self.moved.iter().flat_map(|it| &it.copies).any(|it| declares(it, &name)) {
                name.push('%');
            }
            self.bind_as(&own, &name);
            let value = Some(tree::Expr::local(&known, site));
            stmts.push(tree::Stmt::Let { name, slot: tree::NO_SLOT, value, site, mutable: true });
        }
        stmts
    }

    /// Returns the variables that a `move` closure captures and that may change.
    fn captured(&self, closure: &syn::ExprClosure) -> Vec<String> {
        if closure.capture.is_none() {
            return Vec::new();
        }
        let parameter = |name: &str| closure.inputs.iter().any(|it| names(it, name));
        let mut captured = self.mutable.clone();
        captured.sort();
        captured.dedup();
        captured.retain(|name| {
            let is_variable = |it| !self.is_closure(it) && !self.is_called(name);
            names(&closure.body, name)
                && !parameter(name)
                && self.local_name(name).is_some_and(is_variable)
        });
        captured
    }

    /// Returns true if a name had its meaning before the present statement.
    fn is_bound_before(&self, name: &str, (scopes, names): (usize, usize)) -> bool {
        let at = self.scopes.iter().enumerate().rev().find_map(|(at, scope)| {
            Some((at, scope.iter().rposition(|(known, _)| known == name)?))
        });
        at.is_some_and(|(scope, at)| scope + 1 < scopes || scope + 1 == scopes && at < names)
    }

    /// Refuses a `move` closure that still has variables to copy.
    pub(super) fn check_capture(&mut self, closure: &syn::ExprClosure) {
        if let Some(token) = &closure.capture
            && self.mutable.iter().any(|name| names(&closure.body, name))
        {
            self.refusals.add(token.span, refuse::CLOSURE_MOVE);
        }
    }
}

fn declares(stmt: &tree::Stmt, wanted: &str) -> bool {
    matches!(stmt, tree::Stmt::Let { name, .. } if name == wanted)
}
