//! Views of matrices that have a name: `let mut part = m.column_mut(j); part += &v;`.
//!
//! In the tree and in the copy the name is a value of its own, read where it is named, and written to the matrix behind the
//! last statement that names it. Nobody can tell: while the view lives, Rust lets nothing else touch the matrix. Where the function
//! may leave in between, every statement that names the view writes it. A view that is handed on, or named beside its matrix in
//! one branch of a statement, keeps its refusal.
//!
//! A write to a view without a name gives it one first: `m.column_mut(j)[i] = x`, `for x in m.row_mut(i).iter_mut()`.

use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens, format_ident};
use syn::parse_quote;
use syn::visit::{self, Visit};

use super::expr::is_unit_control;
use super::syntax::{names, times_named};
use super::view::{may_repeat, set, written};
use super::walk::Lowering;

impl Lowering<'_> {
    /// Gives each view that has a name in a block a value of its own.
    pub(super) fn views_with_names(&self, stmts: &mut Vec<syn::Stmt>) {
        let mut at = 0;
        while at < stmts.len() {
            match self.view_with_name(&stmts[at..]) {
                Some((passed, replaced)) => {
                    stmts.splice(at..at + passed, replaced);
                }
                None => at += 1,
            }
        }
    }

    /// The expansion of the statements up to the last that names the view which the first declares; and how many these are.
    fn view_with_name(&self, stmts: &[syn::Stmt]) -> Option<(usize, Vec<syn::Stmt>)> {
        let (syn::Stmt::Local(local), rest) = stmts.split_first()? else { return None };
        let syn::Pat::Ident(name) = &local.pat else { return None };
        let init = local.init.as_ref().filter(|init| init.diverge.is_none())?;
        let mut value = (*init.expr).clone();
        let (view, kind) = written(&mut value)?;
        if !is_named(&view.receiver) {
            return None;
        }
        let names_it = |stmt: &syn::Stmt| names(stmt, &name.ident.to_string());
        let last = rest.iter().rposition(names_it)?;
        let live = &rest[..=last];
        let leaves = live.iter().any(may_leave);
        for stmt in live.iter().filter(|stmt| names_it(stmt)) {
            let branches = is_compound(stmt);
            let apart = !branches || !touches(stmt, &view.receiver) && !may_leave(stmt);
            if !apart || !only_used(stmt, &name.ident) {
                return None;
            }
        }
        let mut view = view.clone();
        let mut replaced: Vec<syn::Stmt> = Vec::new();
        let is_one = matches!(live, [syn::Stmt::Expr(..)]);
        for (at, role) in view.args.iter_mut().zip(["at", "beside"]) {
            if !(matches!(at, syn::Expr::Lit(_)) || is_one && self.never_changes(at)) {
                let fresh = self.fresh_beside_all(&format!("{}_{role}", name.ident), stmts);
                replaced.push(parse_quote! { let #fresh = #at; });
                *at = parse_quote! { #fresh };
            }
        }
        let mut read = view.clone();
        read.method = format_ident!("{kind}", span = view.method.span());
        let ident = &name.ident;
        let mut declared = local.clone();
        declared.pat = parse_quote! { mut #ident };
        if let Some(init) = &mut declared.init {
            *init.expr = parse_quote! { #read.into_owned() };
        }
        replaced.push(syn::Stmt::Local(declared));
        let write: syn::Stmt = {
            let set = set(&view, &kind, parse_quote! { &#ident });
            parse_quote! { #set; }
        };
        for (index, stmt) in live.iter().enumerate() {
            let writes = index == last || leaves && names_it(stmt);
            match stmt {
                // Whether it has a value cannot be told.
                syn::Stmt::Expr(value, None)
                    if index + 1 == rest.len() && is_compound(stmt) && !is_unit_control(value) =>
                {
                    return None;
                }
                // The value of the block is known before the view is written.
                syn::Stmt::Expr(value, None) if index + 1 == rest.len() && !is_compound(stmt) => {
                    let given = self.fresh_beside_all("given", stmts);
                    replaced.push(parse_quote! { let #given = #value; });
                    replaced.push(write.clone());
                    replaced.push(syn::Stmt::Expr(parse_quote! { #given }, None));
                }
                syn::Stmt::Expr(value, None) => {
                    replaced.push(syn::Stmt::Expr(value.clone(), Some(Default::default())));
                    replaced.extend(writes.then(|| write.clone()));
                }
                stmt => {
                    replaced.push(stmt.clone());
                    replaced.extend(writes.then(|| write.clone()));
                }
            }
        }
        Some((last + 2, replaced))
    }

    /// The write to a view without a name, by one that has a name; none if it is something else.
    pub(super) fn view_without_name(&self, expr: &syn::Expr) -> Option<syn::Expr> {
        match expr {
            syn::Expr::ForLoop(it) => {
                let syn::Expr::MethodCall(elements) = &*it.expr else { return None };
                let mut view = (*elements.receiver).clone();
                written(&mut view).filter(|_| elements.method == "iter_mut")?;
                let name = self.fresh_in("part", expr);
                let mut through = it.clone();
                through.expr = parse_quote! { #name.iter_mut() };
                Some(parse_quote! { { let mut #name = #view; #through } })
            }
            // A copy at each operator of a long chain would take time that grows with the square of its length.
            syn::Expr::Binary(it) if super::expr::compound(&it.op).is_none() => None,
            syn::Expr::Assign(_) | syn::Expr::Binary(_) => {
                let mut write = expr.clone();
                let (place, value) = match &mut write {
                    syn::Expr::Assign(it) => (&mut *it.left, &mut *it.right),
                    syn::Expr::Binary(it) => (&mut *it.left, &mut *it.right),
                    _ => return None,
                };
                let name = self.fresh_in("part", expr);
                let view = element(place, &name)?;
                let mut first: Option<syn::Stmt> = None;
                if !matches!(value, syn::Expr::Lit(_)) {
                    let new = self.fresh_in("value", expr);
                    first = Some(parse_quote! { let #new = #value; });
                    *value = parse_quote! { #new };
                }
                Some(parse_quote! { { #first let mut #name = #view; #write; } })
            }
            syn::Expr::MethodCall(it) => {
                let mut receiver = (*it.receiver).clone();
                let (view, _) = written(&mut receiver)?;
                let mut named: Option<syn::Stmt> = None;
                if !is_named(&view.receiver) {
                    let (matrix, place) = (self.fresh_beside("matrix", it), &view.receiver);
                    named = Some(parse_quote! { let #matrix = &mut #place; });
                    *view.receiver = parse_quote! { #matrix };
                }
                let name = self.fresh_beside("part", it);
                let (method, turbofish, arguments) = (&it.method, &it.turbofish, &it.args);
                Some(parse_quote! {
                    { #named let mut #name = #receiver; #name.#method #turbofish(#arguments) }
                })
            }
            _ => None,
        }
    }

    /// Whether an index is made of numbers and of names that are not `mut`.
    fn never_changes(&self, index: &syn::Expr) -> bool {
        match index {
            syn::Expr::Lit(_) => true,
            syn::Expr::Path(it) => !self.mutable.iter().any(|name| it.path.is_ident(name)),
            syn::Expr::Paren(it) => self.never_changes(&it.expr),
            syn::Expr::Cast(it) => self.never_changes(&it.expr),
            syn::Expr::Binary(it) => {
                may_repeat(index) && self.never_changes(&it.left) && self.never_changes(&it.right)
            }
            _ => false,
        }
    }

    /// A name that nothing in scope has, nor in the statements.
    fn fresh_beside_all(&self, name: &str, stmts: &[syn::Stmt]) -> syn::Ident {
        let stmts = stmts.to_vec();
        self.fresh_in(name, &parse_quote! { { #(#stmts)* } })
    }
}

/// The view whose element a place is, which becomes that of the view's name.
fn element(place: &mut syn::Expr, name: &syn::Ident) -> Option<syn::Expr> {
    let syn::Expr::Index(it) = place else { return None };
    written(&mut it.expr)?;
    Some(std::mem::replace(&mut *it.expr, parse_quote! { #name }))
}

/// Whether a receiver is made of names and fields alone: an index may mean another element later.
fn is_named(receiver: &syn::Expr) -> bool {
    let mut tokens = receiver.to_token_stream().into_iter();
    may_repeat(receiver) && tokens.all(|token| !matches!(token, TokenTree::Group(_)))
}

fn is_compound(stmt: &syn::Stmt) -> bool {
    let expr = match stmt {
        syn::Stmt::Expr(expr, _) => expr,
        syn::Stmt::Local(it) => match &it.init {
            Some(init) => &*init.expr,
            None => return false,
        },
        syn::Stmt::Item(_) => return false,
        syn::Stmt::Macro(_) => return true,
    };
    matches!(
        expr,
        syn::Expr::If(_)
            | syn::Expr::Match(_)
            | syn::Expr::Block(_)
            | syn::Expr::ForLoop(_)
            | syn::Expr::While(_)
            | syn::Expr::Loop(_)
            | syn::Expr::Closure(_)
    )
}

/// Whether a statement may use the matrix of a view: it has its root, and not just another field of it.
fn touches(stmt: &syn::Stmt, matrix: &syn::Expr) -> bool {
    let path: Vec<String> = matrix
        .to_token_stream()
        .into_iter()
        .filter_map(|token| match token {
            TokenTree::Ident(ident) => Some(ident.to_string()),
            _ => None,
        })
        .collect();
    mentions(stmt.to_token_stream(), &path)
}

fn mentions(tokens: TokenStream, path: &[String]) -> bool {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    tokens.iter().enumerate().any(|(at, token)| match token {
        TokenTree::Group(group) => mentions(group.stream(), path),
        TokenTree::Ident(ident) if path.first().is_some_and(|root| ident == root) => {
            let dot = matches!(tokens.get(at + 1), Some(TokenTree::Punct(it)) if it.as_char() == '.');
            let calls = matches!(tokens.get(at + 3), Some(TokenTree::Group(it)) if it.delimiter() == proc_macro2::Delimiter::Parenthesis);
            match (dot, tokens.get(at + 2), path.get(1)) {
                (true, Some(TokenTree::Ident(field)), Some(own)) => calls || field == own,
                _ => true,
            }
        }
        _ => false,
    })
}

/// Whether the function, or a loop, may be left in a statement.
fn may_leave(stmt: &syn::Stmt) -> bool {
    struct Leaves(bool, u32);
    impl<'ast> Visit<'ast> for Leaves {
        fn visit_expr(&mut self, expr: &'ast syn::Expr) {
            match expr {
                syn::Expr::Return(_) | syn::Expr::Try(_) => self.0 = true,
                syn::Expr::Break(it) => self.0 |= self.1 == 0 || it.label.is_some(),
                syn::Expr::Continue(it) => self.0 |= self.1 == 0 || it.label.is_some(),
                syn::Expr::ForLoop(_) | syn::Expr::While(_) | syn::Expr::Loop(_) => {
                    self.1 += 1;
                    visit::visit_expr(self, expr);
                    self.1 -= 1;
                    return;
                }
                _ => {}
            }
            visit::visit_expr(self, expr);
        }
        fn visit_local(&mut self, it: &'ast syn::Local) {
            self.0 |= it.init.as_ref().is_some_and(|init| init.diverge.is_some());
            visit::visit_local(self, it);
        }
    }
    let mut leaves = Leaves(false, 0);
    leaves.visit_stmt(stmt);
    leaves.0
}

/// Whether a view is named as an operand, a receiver or what is indexed, and is nowhere handed on.
fn only_used(stmt: &syn::Stmt, name: &syn::Ident) -> bool {
    struct Uses<'a>(&'a syn::Ident, usize);
    impl Uses<'_> {
        fn count(&mut self, expr: &syn::Expr) {
            match expr {
                syn::Expr::Paren(it) => self.count(&it.expr),
                syn::Expr::Reference(it) if it.mutability.is_none() => self.count(&it.expr),
                syn::Expr::Path(it) if it.path.is_ident(self.0) => self.1 += 1,
                _ => {}
            }
        }
    }
    impl<'ast> Visit<'ast> for Uses<'_> {
        fn visit_expr(&mut self, expr: &'ast syn::Expr) {
            match expr {
                syn::Expr::MethodCall(it) => {
                    self.count(&it.receiver);
                    // By reference it is read: `a.copy_from(&part)`.
                    it.args
                        .iter()
                        .filter(|it| matches!(it, syn::Expr::Reference(_)))
                        .for_each(|it| self.count(it));
                }
                syn::Expr::Index(it) => self.count(&it.expr),
                syn::Expr::Field(it) => self.count(&it.base),
                syn::Expr::Unary(it) if !matches!(it.op, syn::UnOp::Deref(_)) => {
                    self.count(&it.expr)
                }
                syn::Expr::Binary(it) => {
                    self.count(&it.left);
                    self.count(&it.right);
                }
                _ => {}
            }
            visit::visit_expr(self, expr);
        }
    }
    let mut uses = Uses(name, 0);
    uses.visit_stmt(stmt);
    uses.1 == times_named(stmt, &name.to_string())
}
