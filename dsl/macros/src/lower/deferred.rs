//! Iterators and ranges with a name: `let squares = values.iter().map(|x| x * x);`.
//!
//! An iterator does nothing before it is gone through, so it stands where that is, in the tree and in the copy, and its
//! name is nothing there. What it refers to Rust lets nobody change in between.
//!
//! Invariants: what is copied when the iterator is made cannot change before it is gone through; making it cannot fault,
//! since the Rust would do so even where it is never gone through; no name in it means something else there. Any other
//! iterator keeps its refusal.

use syn::parse_quote;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};

use super::each::is_range;
use super::names::text;
use super::syntax::{bare, gives_references, is_iterator, is_plain, names};
use super::walk::Lowering;

impl Lowering<'_> {
    /// Puts the iterators that have names in a block where they are gone through.
    pub(super) fn iterators_with_names(&self, stmts: &mut Vec<syn::Stmt>) {
        let mut at = 0;
        while at < stmts.len() {
            let (before, rest) = stmts.split_at_mut(at + 1);
            match before.last().and_then(|stmt| self.iterator_with_name(stmt, rest)) {
                Some(iterator) => {
                    rest.iter_mut().for_each(|stmt| iterator.clone().visit_stmt_mut(stmt));
                    stmts.remove(at);
                }
                None => at += 1,
            }
        }
    }

    /// The iterator that a statement gives a name, if it can stand in those behind it.
    fn iterator_with_name(&self, stmt: &syn::Stmt, rest: &[syn::Stmt]) -> Option<Named> {
        let syn::Stmt::Local(local) = stmt else { return None };
        let init = local.init.as_ref().filter(|init| init.diverge.is_none())?;
        let syn::Pat::Ident(name) = &local.pat else { return None };
        let plain = name.mutability.is_none() && name.by_ref.is_none() && name.subpat.is_none();
        if !plain || !is_iterator(&init.expr) || !self.is_settled(&init.expr) {
            return None;
        }
        let mut free = Free { bound: Vec::new(), names: vec![text(&name.ident)] };
        free.visit_expr(&init.expr);
        let mut hides = Hides { name: text(&name.ident), free: free.names, found: false };
        rest.iter().for_each(|stmt| hides.visit_stmt(stmt));
        (!hides.found).then(|| Named { name: name.ident.clone(), iterator: (*init.expr).clone() })
    }

    /// Whether what is copied where an iterator is made stays as it is, and whether that cannot fault. A field may change
    /// behind a reference, and so may what a method gives; what is borrowed may not.
    fn is_settled(&self, expr: &syn::Expr) -> bool {
        match bare(expr) {
            syn::Expr::Closure(_) | syn::Expr::Lit(_) => true,
            syn::Expr::Reference(it) => is_plain(&it.expr),
            syn::Expr::Path(it) => !self.mutable.iter().any(|name| it.path.is_ident(name)),
            syn::Expr::MethodCall(it) if gives_references(expr) && is_plain(&it.receiver) => true,
            syn::Expr::MethodCall(it) if is_iterator(expr) => {
                let asks = ASKING.contains(&text(&it.method).as_str());
                let is_sound = |it| if asks { is_above_zero(it) } else { self.is_settled(it) };
                self.is_settled(&it.receiver) && it.args.iter().all(is_sound)
            }
            syn::Expr::Range(it) => {
                [&it.start, &it.end].into_iter().flatten().all(|end| self.is_settled(end))
            }
            syn::Expr::Unary(it) if matches!(it.op, syn::UnOp::Neg(_)) => {
                matches!(bare(&it.expr), syn::Expr::Lit(_))
            }
            syn::Expr::Cast(it) => self.is_settled(&it.expr),
            _ => false,
        }
    }
}

/// Methods that fault where the number that they are given is zero.
const ASKING: [&str; 4] = ["chunks", "chunks_exact", "step_by", "windows"];

fn is_above_zero(expr: &syn::Expr) -> bool {
    let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Int(number), .. }) = bare(expr) else {
        return false;
    };
    number.base10_parse::<u64>().is_ok_and(|number| number > 0)
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
