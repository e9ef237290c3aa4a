//! `move` closures, which use copies of the variables that may change.
//!
//! The copies are declared before the statement, or the closure body, in which the closure is written.
//!
//! Invariant: nothing else in that statement writes such a variable before the closure is made, so the copy has the value
//! that Rust copies. A closure for which this is not known is refused.

use bessemer_tree as tree;
use bessemer_tree::ExprKind;
use syn::visit::{self, Visit};

use super::names::{site, text};
use super::refuse;
use super::syntax::{bare, names};
use super::walk::{Lowering, Moved};

impl Lowering {
    /// Begins a statement that writes these names; returns the copies of the statement around it.
    pub(super) fn begin_copies(&mut self, written: Vec<String>) -> Option<Moved> {
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
        let outer = self.begin_copies(Written::of(|it| it.head(body)));
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

/// Returns the names that a statement may write outside `move` closures, and outside the blocks that come after its head.
pub(super) fn written(stmt: &syn::Stmt) -> Vec<String> {
    Written::of(|it| match stmt {
        syn::Stmt::Local(local) => {
            local.init.iter().for_each(|init| it.visit_expr(&init.expr));
        }
        syn::Stmt::Expr(expr, _) => it.head(expr),
        other => it.visit_stmt(other),
    })
}

/// Visitor that collects the names that may be written.
struct Written(Vec<String>);

impl Written {
    fn of(visit: impl FnOnce(&mut Written)) -> Vec<String> {
        let mut written = Written(Vec::new());
        visit(&mut written);
        written.0
    }

    /// Visits what runs before the blocks of a statement, each of which has statements of its own.
    fn head(&mut self, expr: &syn::Expr) {
        match expr {
            syn::Expr::If(it) => {
                self.visit_expr(&it.cond);
                it.else_branch.iter().for_each(|(_, otherwise)| self.head(otherwise));
            }
            syn::Expr::Match(it) => {
                self.visit_expr(&it.expr);
                for arm in &it.arms {
                    if let syn::Pat::Guard(it) = &arm.pat {
                        self.visit_expr(&it.guard);
                    }
                }
            }
            syn::Expr::ForLoop(it) => self.visit_expr(&it.expr),
            syn::Expr::While(it) => self.visit_expr(&it.cond),
            syn::Expr::Block(_) | syn::Expr::Loop(_) | syn::Expr::Unsafe(_) => {}
            other => self.visit_expr(other),
        }
    }

    /// Notes the variable of a place.
    fn note(&mut self, place: &syn::Expr) {
        match bare(place) {
            syn::Expr::Path(it) => self.0.extend(it.path.get_ident().map(text)),
            syn::Expr::Field(it) => self.note(&it.base),
            syn::Expr::Index(it) => self.note(&it.expr),
            syn::Expr::Unary(it) => self.note(&it.expr),
            syn::Expr::Tuple(it) => it.elems.iter().for_each(|part| self.note(part)),
            syn::Expr::Array(it) => it.elems.iter().for_each(|part| self.note(part)),
            syn::Expr::Reference(it) => self.note(&it.expr),
            syn::Expr::MethodCall(it) => self.note(&it.receiver),
            _ => {}
        }
    }
}

impl<'ast> Visit<'ast> for Written {
    fn visit_expr_assign(&mut self, it: &'ast syn::ExprAssign) {
        self.note(&it.left);
        visit::visit_expr_assign(self, it);
    }

    fn visit_expr_binary(&mut self, it: &'ast syn::ExprBinary) {
        // Of other operators the operands are values.
        if is_assignment(&it.op) {
            self.note(&it.left);
        }
        visit::visit_expr_binary(self, it);
    }

    fn visit_expr_reference(&mut self, it: &'ast syn::ExprReference) {
        if it.mutability.is_some() {
            self.note(&it.expr);
        }
        visit::visit_expr_reference(self, it);
    }

    fn visit_expr_method_call(&mut self, it: &'ast syn::ExprMethodCall) {
        self.note(&it.receiver);
        visit::visit_expr_method_call(self, it);
    }

    fn visit_pat_ident(&mut self, it: &'ast syn::PatIdent) {
        // A name that a pattern binds, or a variable that it borrows.
        self.0.push(text(&it.ident));
    }

    fn visit_expr_closure(&mut self, it: &'ast syn::ExprClosure) {
        if it.capture.is_none() {
            visit::visit_expr_closure(self, it);
        }
    }

    fn visit_macro(&mut self, it: &'ast syn::Macro) {
        fn all(tokens: proc_macro2::TokenStream, found: &mut Vec<String>) {
            for token in tokens {
                match token {
                    proc_macro2::TokenTree::Ident(ident) => found.push(text(&ident)),
                    proc_macro2::TokenTree::Group(group) => all(group.stream(), found),
                    _ => {}
                }
            }
        }
        all(it.tokens.clone(), &mut self.0);
    }
}

/// Returns true for `+=` and its like.
fn is_assignment(op: &syn::BinOp) -> bool {
    use syn::BinOp::{
        AddAssign, BitAndAssign, BitOrAssign, BitXorAssign, DivAssign, MulAssign, RemAssign,
        ShlAssign, ShrAssign, SubAssign,
    };
    matches!(
        op,
        AddAssign(_)
            | SubAssign(_)
            | MulAssign(_)
            | DivAssign(_)
            | RemAssign(_)
            | BitXorAssign(_)
            | BitAndAssign(_)
            | BitOrAssign(_)
            | ShlAssign(_)
            | ShrAssign(_)
    )
}
