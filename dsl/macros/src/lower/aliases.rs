//! Names through which a statement may write a variable that it does not name: closures, iterators and references.
//!
//! Invariant: a binding whose value may borrow a variable mutably is an alias of it; rather one too many.
//!
//! Must not know: types.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::visit::{self, Visit};

use super::names::text;
use super::written::{Named, Written};

/// Bound names, each with the names that may be written through it.
#[derive(Default)]
pub struct Aliases(BTreeMap<String, BTreeSet<String>>);

impl Aliases {
    /// Returns the aliases in the body of a function. Only copies for `move` closures depend on them, so that a body
    /// without such a closure needs none.
    pub fn of(body: &syn::Block) -> Aliases {
        let mut aliases = Aliases::default();
        if has_move(body.to_token_stream()) {
            aliases.visit_block(body);
        }
        aliases
    }

    /// Returns the names that code may write through the aliases that it names outside `move` closures.
    pub(super) fn written_by(&self, visit: impl FnOnce(&mut Named)) -> Vec<String> {
        if self.0.is_empty() {
            return Vec::new();
        }
        let mut open = Named::of(visit);
        let mut written = BTreeSet::new();
        while let Some(alias) = open.pop() {
            for name in self.0.get(&alias).into_iter().flatten() {
                if written.insert(name.clone()) {
                    open.push(name.clone());
                }
            }
        }
        written.into_iter().collect()
    }

    /// Notes that a pattern, or a place, has a value.
    fn note(&mut self, bound: Vec<String>, value: &syn::Expr) {
        let mut of = Written::of(|it| it.visit_expr(value));
        // An alias may be handed on by its name alone.
        let named = Named::of(|it| it.visit_expr(value));
        of.extend(named.into_iter().filter(|name| self.0.contains_key(name)));
        for name in bound {
            let of = of.iter().filter(|it| **it != name).cloned();
            self.0.entry(name.clone()).or_default().extend(of);
        }
    }

    /// Notes the names of a pattern, which borrows with `ref mut`.
    fn note_pattern(&mut self, pattern: &syn::Pat, value: &syn::Expr) {
        let mut bound = Bound::default();
        bound.visit_pat(pattern);
        if bound.borrows {
            let of = Written::of(|it| it.note(value));
            for name in &bound.names {
                self.0.entry(name.clone()).or_default().extend(of.iter().cloned());
            }
        }
        self.note(bound.names, value);
    }
}

impl<'ast> Visit<'ast> for Aliases {
    fn visit_local(&mut self, it: &'ast syn::Local) {
        if let Some(init) = &it.init {
            self.note_pattern(&it.pat, &init.expr);
        }
        visit::visit_local(self, it);
    }

    fn visit_expr_let(&mut self, it: &'ast syn::ExprLet) {
        self.note_pattern(&it.pat, &it.expr);
        visit::visit_expr_let(self, it);
    }

    fn visit_expr_for_loop(&mut self, it: &'ast syn::ExprForLoop) {
        self.note_pattern(&it.pat, &it.expr);
        visit::visit_expr_for_loop(self, it);
    }

    fn visit_expr_match(&mut self, it: &'ast syn::ExprMatch) {
        it.arms.iter().for_each(|arm| self.note_pattern(&arm.pat, &it.expr));
        visit::visit_expr_match(self, it);
    }

    fn visit_expr_assign(&mut self, it: &'ast syn::ExprAssign) {
        let place = Written::of(|written| written.note(&it.left));
        self.note(place, &it.right);
        visit::visit_expr_assign(self, it);
    }
}

/// Returns true if the word `move` is among the tokens.
fn has_move(tokens: TokenStream) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Ident(word) => word == "move",
        TokenTree::Group(group) => has_move(group.stream()),
        _ => false,
    })
}

/// Names that a pattern binds.
#[derive(Default)]
struct Bound {
    names: Vec<String>,
    /// True if one of them is `ref mut`.
    borrows: bool,
}

impl<'ast> Visit<'ast> for Bound {
    fn visit_pat_ident(&mut self, it: &'ast syn::PatIdent) {
        self.names.push(text(&it.ident));
        self.borrows |= it.by_ref.is_some() && it.mutability.is_some();
        visit::visit_pat_ident(self, it);
    }
}
