//! Closures that do not escape: bound to a name and called, or passed to an iterator method.
//!
//! The tree has the closure at its definition, and its name where it is called or passed.

use bessemer_tree as tree;
use bessemer_tree::{ExprKind, NO_SLOT};
use proc_macro2::Span;
use quote::quote;
use syn::visit::{self, Visit};

use super::handed::is_function;
use super::names::{generating, plain, site, text};
use super::refuse::Refusals;
use super::signature::Names;
use super::walk::Lowering;
use super::{pattern, refuse};

impl Lowering {
    /// Lowers `let f = |x| …;` or `let f = f64::abs;`, and registers the name. A `move` closure uses copies of the
    /// variables that may change.
    pub(super) fn closure_local(&mut self, local: &mut syn::Local) -> Vec<tree::Stmt> {
        let site = site(&local.let_token);
        let Some(init) = local.init.as_mut() else { return Vec::new() };
        let named = match &*init.expr {
            syn::Expr::Path(path) => Some(path.clone()),
            _ => None,
        };
        let mut stmts = Vec::new();
        let mut value = self.scoped(|walk| {
            if let syn::Expr::Closure(closure) = &mut *init.expr {
                stmts = walk.copies(closure);
            }
            walk.argument(&mut init.expr)
        });
        let Some(own) = pattern::simple_name(&mut local.pat, &mut self.refusals) else {
            return stmts;
        };
        let own = text(&own);
        // Marked, so that a variable of its name that hides it is not taken for it.
        let name = self.hidden(&format!("{own}%"));
        self.bind_as(&own, &name);
        self.functions.extend(named.map(|path| (name.clone(), path)));
        self.closures.push(name.clone());
        if let ExprKind::Closure(closure) = &mut value.kind {
            closure.name = Some(own);
        }
        stmts.push(tree::Stmt::Let {
            name,
            slot: NO_SLOT,
            value: Some(value),
            site,
            mutable: false,
        });
        stmts
    }

    /// Returns true if an expression names a function: its last segment has no capitals, since a constant may begin
    /// with a small letter.
    pub(super) fn names_function(&self, expr: &syn::Expr) -> bool {
        let syn::Expr::Path(path) = expr else { return false };
        let is_local = path.path.get_ident().is_some_and(|it| self.is_local(&text(it)));
        let last = path.path.segments.last().map(|it| text(&it.ident)).unwrap_or_default();
        !is_local && is_function(path) && !last.contains(char::is_uppercase)
    }

    /// Returns the tree's name of a closure, or of a parameter that takes one.
    pub(super) fn called_name(&self, name: &str) -> Option<String> {
        let in_tree = self.local_name(name)?;
        (self.is_called(name) || self.is_closure(in_tree)).then(|| in_tree.to_owned())
    }

    pub(super) fn is_closure(&self, in_tree: &str) -> bool {
        self.closures.iter().any(|name| name == in_tree)
    }

    /// Lowers an argument of a call: a closure, or a value.
    pub(super) fn argument(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        match expr {
            syn::Expr::Paren(it) if matches!(&*it.expr, syn::Expr::Closure(_)) => {
                self.argument(&mut it.expr)
            }
            syn::Expr::Closure(closure) => {
                let place = closure.clone();
                let kind = self.scoped(|walk| {
                    walk.copied_before(closure);
                    let mut looks = Vec::new();
                    let inputs = closure.inputs.iter();
                    let parameters = inputs.map(|it| walk.pattern(it, &mut looks)).collect();
                    let body = walk.closure_body(closure, looks);
                    let body = Box::new(body);
                    ExprKind::Closure(tree::Closure { name: None, parameters, body })
                });
                plain(kind, &place)
            }
            // What is lent to be called is called there.
            syn::Expr::Reference(it) if self.is_called_value(&it.expr) => {
                self.argument(&mut it.expr)
            }
            syn::Expr::Path(path) => {
                let name = path.path.get_ident().map(text);
                let is_local = name.as_ref().is_some_and(|name| self.is_local(name));
                match name.and_then(|name| self.called_name(&name)) {
                    // Handed on as it came.
                    Some(name) => plain(ExprKind::Local(name), path),
                    None if !is_local && is_function(path) => self.named_argument(expr),
                    None => self.value(expr),
                }
            }
            other => self.value(other),
        }
    }

    /// Returns true if an expression is a closure, or names one.
    fn is_called_value(&self, expr: &syn::Expr) -> bool {
        match expr {
            syn::Expr::Closure(_) => true,
            syn::Expr::Paren(it) => self.is_called_value(&it.expr),
            syn::Expr::Path(it) => {
                it.path.get_ident().is_some_and(|it| self.called_name(&text(it)).is_some())
            }
            _ => false,
        }
    }

    /// Returns true if a name is a parameter that takes a closure.
    pub(super) fn is_called(&self, name: &str) -> bool {
        self.called.iter().any(|known| known == name)
            && self.bindings(name) == 1
            && self.local_name(name) == Some(name)
    }

    /// Lowers the body of a closure; the statements `looks`, which record its parameters' types, come first in the
    /// copy.
    pub(super) fn closure_body(
        &mut self,
        closure: &mut syn::ExprClosure,
        looks: Vec<syn::Stmt>,
    ) -> tree::Expr {
        self.check_capture(closure);
        // Slots are no part of what it moves.
        closure.capture = None;
        // What leaves the closure leaves its body, which stands where the closure is called.
        let label = (!Returns::of(|it| it.visit_expr(&closure.body)).is_empty())
            .then(|| self.hidden("answer"));
        let outer = std::mem::replace(&mut self.leaves, label.clone());
        let mut body = self.in_body(&mut closure.body, Self::value);
        self.leaves = outer;
        if body.slot.is_none() {
            body.slot = Some(self.see(&mut closure.body));
        }
        let copy = &closure.body;
        // Behind it rustc checks no borrows: an operand that the body moves is looked at first.
        let unreached = generating().then(|| quote! { __unreached(); });
        *closure.body = syn::Expr::Verbatim(quote! { { #unreached #(#looks)* #copy } });
        let Some(label) = label else { return body };
        let (site, slot) = (body.site, body.slot);
        let block = tree::Block { stmts: Vec::new(), tail: Some(Box::new(body)) };
        tree::Expr { kind: ExprKind::Labelled(label, block), site, slot }
    }

    /// Lowers the body of an inlined function, in which an early exit leaves only the body.
    pub fn expanded_body(
        &mut self,
        body: &mut syn::Block,
        (signature, result): (&syn::Signature, u32),
    ) -> tree::Block {
        if Returns::of(|it| it.visit_block(body)).is_empty() {
            return self.block(body);
        }
        let label = self.hidden("answer");
        self.leaves = Some(label.clone());
        let body = self.block(body);
        self.leaves = None;
        let (kind, site) = (ExprKind::Labelled(label, body), site(&signature.ident));
        match &signature.output {
            syn::ReturnType::Default => {
                let whole = tree::Expr { kind, site, slot: None };
                tree::Block { stmts: vec![tree::Stmt::Expr(whole)], tail: None }
            }
            syn::ReturnType::Type(..) => {
                let whole = tree::Expr { kind, site, slot: Some(result) };
                tree::Block { stmts: Vec::new(), tail: Some(Box::new(whole)) }
            }
        }
    }
}

/// Returns the names that a function declares `mut`; a copy of one may differ from the later value.
pub fn mutable_names(signature: &syn::Signature, body: &syn::Block) -> Vec<String> {
    let mut mutable = Vec::new();
    let note = |it: &syn::PatIdent| mutable.extend(it.mutability.map(|_| text(&it.ident)));
    let mut names = Names(note);
    names.visit_signature(signature);
    names.visit_block(body);
    mutable
}

/// Refuses statements in an inlined function that would leave its caller.
pub fn without_returns(body: &syn::Block, refusals: &mut Refusals) {
    for span in Returns::of(|it| it.visit_block(body)) {
        refusals.add(span, refuse::EXPANDED_RETURN);
    }
}

/// Visitor that finds the expressions that would leave a closure early.
struct Returns(Vec<Span>);

impl Returns {
    fn of(visit: impl FnOnce(&mut Returns)) -> Vec<Span> {
        let mut returns = Returns(Vec::new());
        visit(&mut returns);
        returns.0
    }
}

impl<'ast> Visit<'ast> for Returns {
    fn visit_expr_return(&mut self, it: &'ast syn::ExprReturn) {
        self.0.push(it.return_token.span);
        visit::visit_expr_return(self, it);
    }
    fn visit_expr_try(&mut self, it: &'ast syn::ExprTry) {
        self.0.push(it.question_token.span);
        visit::visit_expr_try(self, it);
    }
    fn visit_expr_closure(&mut self, _: &'ast syn::ExprClosure) {}
}
