//! Closures that do not escape: bound to a name and called, or written where an iterator takes one.
//!
//! The tree has a closure's body where it is called; the witness copy keeps the closure.

use bessemer_tree as tree;
use bessemer_tree::{ExprKind, Start};
use proc_macro2::Span;
use quote::quote;
use syn::parse_quote;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

use super::handed::is_function;
use super::names::{plain, site, text};
use super::pattern::alone;
use super::refuse::Refusals;
use super::signature::Names;
use super::syntax::names;
use super::walk::{Closure, Lowering};
use super::{macros, pattern, refuse};

impl Lowering {
    /// `let f = |x| …;`: the closure is known by its name from here on.
    pub(super) fn closure_local(&mut self, local: &mut syn::Local) -> bool {
        let Some(init) = &mut local.init else { return false };
        let syn::Expr::Closure(closure) = &mut *init.expr else { return false };
        let Some(ident) = pattern::simple_name(&mut local.pat, &mut self.refusals) else {
            return true;
        };
        let known: std::collections::BTreeSet<_> =
            self.scopes.iter().flatten().map(|(known, _)| known.clone()).collect();
        let uses: Vec<_> = known.into_iter().map(|known| (self.bindings(&known), known)).collect();
        // A name that it binds itself, as a parameter, is none that it uses.
        let bare = syn::ExprClosure { body: parse_quote! { {} }, ..closure.clone() };
        let mut parameters = Vec::new();
        let body = self.scoped(|walk| {
            let mut looks = Vec::new();
            for input in &closure.inputs {
                let Some(name) = alone(input).map(|it| it.ident.clone()) else {
                    let outer = walk.apart.replace("%");
                    parameters.push(walk.pattern(input, &mut looks));
                    walk.apart = outer;
                    continue;
                };
                let slot = walk.slot();
                looks.push(walk.look(slot, &name));
                let name = text(&name);
                // Marked, so that an argument never means the parameter of another.
                let in_tree = walk.bind_apart(&name);
                walk.bind_as(&name, &format!("{in_tree}%"));
                let name = format!("{in_tree}%");
                parameters.push(tree::Pattern::Name { name, slot, mutable: false, inner: None });
            }
            walk.closure_body(closure, looks)
        });
        // Marked, so that a variable of its name that hides it is not taken for it.
        let name = self.hidden(&format!("{}%", text(&ident)));
        self.bind_as(&text(&ident), &name);
        let mut own = Vec::new();
        Names(|it: &syn::PatIdent| own.push(text(&it.ident))).visit_expr_closure(&bare);
        let uses = uses
            .into_iter()
            .filter(|(_, known)| !own.contains(known) && names(&init.expr, known))
            .collect();
        self.closures.push(Closure { name, parameters, body, uses });
        true
    }

    pub(super) fn is_closure(&self, in_tree: &str) -> bool {
        self.closures.iter().any(|closure| closure.name == in_tree)
    }

    /// `f(a, b)`: the body, its parameters the arguments.
    pub(super) fn closure_call(
        &mut self,
        name: &str,
        arguments: &[tree::Expr],
        span: Span,
    ) -> Option<ExprKind> {
        let (parameters, body) = self.closure_named(name, span)?;
        let stmts = parameters.into_iter().zip(arguments).map(|(parameter, argument)| {
            let (value, site) = (argument.clone(), argument.site);
            match parameter {
                tree::Pattern::Name { name, slot, inner: None, .. } => {
                    tree::Stmt::Let { name, slot, value: Some(value), site, mutable: false }
                }
                pattern => {
                    tree::Stmt::Apart { pattern: Box::new(pattern), value, otherwise: None, site }
                }
            }
        });
        Some(ExprKind::Block(tree::Block { stmts: stmts.collect(), tail: Some(body) }))
    }

    /// `core::array::from_fn(|i| …)`: a loop through the array, whose elements the closure gives by their indices.
    pub(super) fn array_from_fn(&mut self, it: &mut syn::ExprCall) -> Option<ExprKind> {
        let syn::Expr::Path(function) = &*it.func else { return None };
        let (home, last) = macros::in_module(&function.path)?;
        if home != "array" || last != "from_fn" || it.args.len() != 1 {
            return None;
        }
        let last = last.clone();
        if !matches!(it.args[0], syn::Expr::Closure(_)) {
            return None;
        }
        self.ask_home(&function.path);
        let syn::Expr::Closure(closure) = &mut it.args[0] else { return None };
        self.scoped(|walk| {
            let (index, looks) = match closure.inputs.first()? {
                syn::Pat::Wild(_) => (walk.hidden("i"), Vec::new()),
                other => {
                    let (name, slot) = (alone(other)?.ident.clone(), walk.slot());
                    (walk.bind_apart(&text(&name)), vec![walk.look(slot, &name)])
                }
            };
            let value = Box::new(walk.closure_body(closure, looks));
            let (name, site) = (walk.hidden("elements"), site(&last));
            let [array, index_of] = [&name, &index].map(|name| tree::Expr::local(name, site));
            let element = ExprKind::Index(Box::new(array.clone()), Box::new(index_of));
            let element = Box::new(tree::Expr::plain(element, site));
            let pass = tree::Expr::plain(ExprKind::Assign(None, element, value), site);
            let pattern = tree::Pattern::Any;
            let part = tree::Part { pattern, array, owned: false, group: None, reversed: false };
            let each = ExprKind::each(Some(&index), part, pass);
            let each = Box::new(tree::Expr::plain(each, site));
            Some(ExprKind::Fold { name, start: Start::Elements, each })
        })
    }

    /// An argument of a call: a closure, or a value.
    pub(super) fn argument(&mut self, expr: &mut syn::Expr) -> tree::Expr {
        match expr {
            syn::Expr::Paren(it) if matches!(&*it.expr, syn::Expr::Closure(_)) => {
                self.argument(&mut it.expr)
            }
            syn::Expr::Closure(closure) => {
                let place = closure.clone();
                let kind = self.scoped(|walk| {
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
            syn::Expr::Path(path) => match path.path.get_ident().map(text) {
                // Handed on as it came.
                Some(name) if self.is_called(&name) => plain(ExprKind::Local(name), path),
                Some(name) if self.is_local(&name) => {
                    match self.closure_value(&name, path.span()) {
                        Some(kind) => plain(kind, path),
                        None => self.value(expr),
                    }
                }
                _ if is_function(path) => self.named_argument(expr),
                _ => self.value(expr),
            },
            other => self.value(other),
        }
    }

    /// Whether an expression is a closure, or the name of one.
    fn is_called_value(&self, expr: &syn::Expr) -> bool {
        match expr {
            syn::Expr::Closure(_) => true,
            syn::Expr::Paren(it) => self.is_called_value(&it.expr),
            syn::Expr::Path(it) => it.path.get_ident().map(text).is_some_and(|name| {
                let known = |name: &str| self.is_closure(name);
                self.is_called(&name) || self.local_name(&name).is_some_and(known)
            }),
            _ => false,
        }
    }

    /// Whether a name is that of a parameter that takes a closure.
    pub(super) fn is_called(&self, name: &str) -> bool {
        self.called.iter().any(|known| known == name)
            && self.bindings(name) == 1
            && self.local_name(name) == Some(name)
    }

    /// A closure by its name, as an argument.
    fn closure_value(&mut self, name: &str, span: Span) -> Option<ExprKind> {
        let (parameters, body) = self.closure_named(name, span)?;
        Some(ExprKind::Closure(tree::Closure { name: Some(name.to_owned()), parameters, body }))
    }

    /// The parameters and the body of a closure, which is used at `span`.
    fn closure_named(
        &mut self,
        name: &str,
        span: Span,
    ) -> Option<(Vec<tree::Pattern>, Box<tree::Expr>)> {
        let in_tree = self.local_name(name)?;
        let closure = self.closures.iter().rev().find(|closure| closure.name == in_tree)?;
        let found = (closure.parameters.clone(), Box::new(closure.body.clone()));
        // A name that the closure uses may mean something else by now.
        if closure.uses.iter().any(|(count, known)| self.bindings(known) != *count) {
            self.refusals.add(span, refuse::CLOSURE_SHADOWED);
        }
        Some(found)
    }

    /// The value of a closure's body; `looks` at its parameters come first in the copy.
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
        let mut body = self.value(&mut closure.body);
        self.leaves = outer;
        if body.slot.is_none() {
            body.slot = Some(self.see(&mut closure.body));
        }
        let copy = &closure.body;
        *closure.body = syn::Expr::Verbatim(quote! { { #(#looks)* #copy } });
        let Some(label) = label else { return body };
        let (site, slot) = (body.site, body.slot);
        let block = tree::Block { stmts: Vec::new(), tail: Some(Box::new(body)) };
        tree::Expr { kind: ExprKind::Labelled(label, block), site, slot }
    }

    /// The body of a function that stands where it is called: what leaves it early leaves its body there.
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

    /// What a closure moves is a copy: of what nobody changes it is the same.
    fn check_capture(&mut self, closure: &syn::ExprClosure) {
        if let Some(token) = &closure.capture
            && self.mutable.iter().any(|name| names(&closure.body, name))
        {
            self.refusals.add(token.span, refuse::CLOSURE_MOVE);
        }
    }
}

/// The names that a function declares `mut`, of which a copy may differ from what was copied.
pub fn mutable_names(signature: &syn::Signature, body: &syn::Block) -> Vec<String> {
    let mut mutable = Vec::new();
    let note = |it: &syn::PatIdent| mutable.extend(it.mutability.map(|_| text(&it.ident)));
    let mut names = Names(note);
    names.visit_signature(signature);
    names.visit_block(body);
    mutable
}

/// Refuses what would leave the caller of a function that stands where it is called.
pub fn without_returns(body: &syn::Block, refusals: &mut Refusals) {
    for span in Returns::of(|it| it.visit_block(body)) {
        refusals.add(span, refuse::EXPANDED_RETURN);
    }
}

/// The expressions that would leave a closure early.
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
