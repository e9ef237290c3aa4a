//! Ranges with a name: `let middle = 1..n - 1;`.
//!
//! A range does nothing before it is gone through, so it stands where that is, in the tree and in the copy, and its name is
//! nothing there.
//!
//! Invariants: what is copied when the range is made cannot change before it is gone through, so a number that may, or that
//! may fault, gets a name of its own where the range is made; no name in it means something else later. Any other range
//! keeps its refusal.

use syn::parse_quote;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};

use super::link::is_range;
use super::names::text;
use super::syntax::{bare, is_plain, names};
use super::walk::Lowering;

impl Lowering<'_> {
    /// Puts the iterators that have names in a block where they are gone through.
    pub(super) fn iterators_with_names(&self, stmts: &mut Vec<syn::Stmt>) {
        let mut at = 0;
        while at < stmts.len() {
            let (before, rest) = stmts.split_at_mut(at + 1);
            match before.last().and_then(|stmt| self.iterator_with_name(stmt, rest)) {
                Some((iterator, made)) => {
                    rest.iter_mut().for_each(|stmt| iterator.clone().visit_stmt_mut(stmt));
                    let count = made.len();
                    stmts.splice(at..=at, made);
                    at += count;
                }
                None => at += 1,
            }
        }
    }

    /// The iterator that a statement gives a name, if it can stand in those behind it, and what is computed where it is made.
    fn iterator_with_name(
        &self,
        stmt: &syn::Stmt,
        rest: &[syn::Stmt],
    ) -> Option<(Named, Vec<syn::Stmt>)> {
        let syn::Stmt::Local(local) = stmt else { return None };
        let init = local.init.as_ref().filter(|init| init.diverge.is_none())?;
        let syn::Pat::Ident(name) = &local.pat else { return None };
        let plain = name.mutability.is_none() && name.by_ref.is_none() && name.subpat.is_none();
        let mut made = Made { name: &name.ident, stmts: Vec::new(), names: Vec::new() };
        let mut iterator = (*init.expr).clone();
        if !plain || !is_range(&iterator) {
            return None;
        }
        self.settle(&mut iterator, &mut made);
        let mut free = Free { bound: Vec::new(), names: vec![text(&name.ident)] };
        free.visit_expr(&iterator);
        let mut hides = Hides { name: text(&name.ident), free: free.names, found: false };
        rest.iter().for_each(|stmt| hides.visit_stmt(stmt));
        hides.found |= made.names.iter().any(|own| rest.iter().any(|stmt| names(stmt, own)));
        (!hides.found).then(|| (Named { name: name.ident.clone(), iterator }, made.stmts))
    }

    /// Gives what is copied where a range is made a name there, unless it stays as it is.
    fn settle(&self, range: &mut syn::Expr, made: &mut Made<'_>) {
        match range {
            syn::Expr::Paren(it) => self.settle(&mut it.expr, made),
            syn::Expr::Range(it) => {
                for (end, role) in [(&mut it.start, "start"), (&mut it.end, "end")] {
                    end.iter_mut().for_each(|end| self.settle_number(end, made, (role, false)));
                }
            }
            syn::Expr::MethodCall(it) => {
                self.settle(&mut it.receiver, made);
                it.args.iter_mut().for_each(|it| self.settle_number(it, made, ("count", true)));
            }
            _ => {}
        }
    }

    /// Gives a number a name where the iterator is made, unless it is the same later. A size of zero `faults` there.
    fn settle_number(
        &self,
        number: &mut syn::Expr,
        made: &mut Made<'_>,
        (role, faults): (&str, bool),
    ) {
        if !self.is_settled(number) {
            let name = made.fresh(role);
            made.stmts.push(parse_quote! { let #name = #number; });
            *number = parse_quote! { #name };
        }
        if faults && !is_above_zero(number) {
            made.stmts.push(parse_quote! { assert!(#number > 0); });
        }
    }

    /// Whether what is copied where an iterator is made stays as it is, and whether that cannot fault. A field may change
    /// behind a reference, and so may what a method gives; what is borrowed may not.
    fn is_settled(&self, expr: &syn::Expr) -> bool {
        match bare(expr) {
            syn::Expr::Closure(_) | syn::Expr::Lit(_) => true,
            syn::Expr::Reference(it) => is_plain(&it.expr),
            syn::Expr::Path(it) => !self.mutable.iter().any(|name| it.path.is_ident(name)),
            syn::Expr::Unary(it) if matches!(it.op, syn::UnOp::Neg(_)) => {
                matches!(bare(&it.expr), syn::Expr::Lit(_))
            }
            syn::Expr::Cast(it) => self.is_settled(&it.expr),
            _ => false,
        }
    }
}

fn is_above_zero(expr: &syn::Expr) -> bool {
    let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Int(number), .. }) = bare(expr) else {
        return false;
    };
    number.base10_parse::<u64>().is_ok_and(|number| number > 0)
}

/// What is computed where an iterator is made.
struct Made<'a> {
    /// The iterator's name.
    name: &'a syn::Ident,
    /// The statements.
    stmts: Vec<syn::Stmt>,
    /// The names that they give.
    names: Vec<String>,
}

impl Made<'_> {
    /// A name for a number, after the iterator's.
    fn fresh(&mut self, role: &str) -> syn::Ident {
        let mut name = format!("{}_{role}", text(self.name));
        while self.names.contains(&name) {
            name.push('_');
        }
        self.names.push(name.clone());
        syn::Ident::new(&name, self.name.span())
    }
}

/// An iterator, and the name in whose place it stands.
#[derive(Clone)]
struct Named {
    name: syn::Ident,
    iterator: syn::Expr,
}

impl VisitMut for Named {
    fn visit_expr_mut(&mut self, expr: &mut syn::Expr) {
        let is_it =
            |expr: &syn::Expr| matches!(expr, syn::Expr::Path(it) if it.path.is_ident(&self.name));
        let again = matches!(expr, syn::Expr::MethodCall(it) if it.method == "clone" && is_it(&it.receiver));
        if again || is_it(expr) {
            let iterator = &self.iterator;
            *expr = match is_range(iterator) {
                true => parse_quote! { (#iterator) },
                false => iterator.clone(),
            };
            return;
        }
        visit_mut::visit_expr_mut(self, expr);
        if let syn::Expr::Index(it) = expr
            && let range @ syn::Expr::Range(_) = bare(&it.index)
        {
            *it.index = range.clone();
        }
    }
}

/// The names in an iterator that its closures do not bind.
struct Free {
    bound: Vec<Vec<String>>,
    names: Vec<String>,
}

impl<'ast> Visit<'ast> for Free {
    fn visit_expr_closure(&mut self, it: &'ast syn::ExprClosure) {
        let mut bound = Bound(Vec::new());
        bound.visit_expr_closure(it);
        self.bound.push(bound.0);
        visit::visit_expr(self, &it.body);
        self.bound.pop();
    }

    fn visit_expr_path(&mut self, it: &'ast syn::ExprPath) {
        if let Some(name) = it.path.get_ident().map(text)
            && !self.bound.iter().flatten().any(|bound| *bound == name)
        {
            self.names.push(name);
        }
    }
}

/// The names that patterns bind.
struct Bound(Vec<String>);

impl<'ast> Visit<'ast> for Bound {
    fn visit_pat_ident(&mut self, it: &'ast syn::PatIdent) {
        self.0.push(text(&it.ident));
        visit::visit_pat_ident(self, it);
    }
}

/// Looks for what gives a name in an iterator, or its own, another meaning; and for its own where no expression is seen.
struct Hides {
    name: String,
    free: Vec<String>,
    found: bool,
}

impl<'ast> Visit<'ast> for Hides {
    fn visit_pat_ident(&mut self, it: &'ast syn::PatIdent) {
        self.found |= self.free.contains(&text(&it.ident));
        visit::visit_pat_ident(self, it);
    }

    fn visit_macro(&mut self, it: &'ast syn::Macro) {
        self.found |= names(&it.tokens, &self.name);
    }
}
