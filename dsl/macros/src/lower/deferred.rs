//! Named ranges: `let middle = 1..n - 1;`.
//!
//! A range has no effect before it is iterated, so tree and copy have it where it is iterated, and no variable for
//! it.
//!
//! Invariants: a bound that may change later, or that may fault, gets a variable where the range is made. No name in
//! the range has another meaning where it is iterated. Any other named range is refused.

use syn::parse_quote;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};

use super::link::is_range;
use super::names::text;
use super::syntax::{bare, is_plain, names};
use super::walk::Lowering;

impl Lowering {
    /// Moves the named ranges of a block to where they are iterated.
    pub(super) fn ranges_with_names(&self, stmts: &mut Vec<syn::Stmt>) {
        let mut at = 0;
        while at < stmts.len() {
            let (before, rest) = stmts.split_at_mut(at + 1);
            let Some((mut named, made)) = self.range_with_name(&before[at], rest) else {
                at += 1;
                continue;
            };
            rest.iter_mut().for_each(|stmt| named.visit_stmt_mut(stmt));
            let count = made.len();
            stmts.splice(at..=at, made);
            at += count;
        }
    }

    /// Returns the named range of a statement, if it can be moved into the statements after it, and the variables for
    /// its bounds.
    fn range_with_name(
        &self,
        stmt: &syn::Stmt,
        rest: &[syn::Stmt],
    ) -> Option<(Named, Vec<syn::Stmt>)> {
        let syn::Stmt::Local(local) = stmt else { return None };
        let init = local.init.as_ref().filter(|init| init.diverge.is_none())?;
        let syn::Pat::Ident(name) = &local.pat else { return None };
        let plain = name.mutability.is_none() && name.by_ref.is_none() && name.subpat.is_none();
        if !plain || !is_range(&init.expr) {
            return None;
        }
        let mut named = Named { name: name.ident.clone(), range: (*init.expr).clone() };
        let mut made = Made { name: &name.ident, stmts: Vec::new(), names: Vec::new() };
        self.settle(&mut named.range, &mut made);
        let mut hides = Hides { name: text(&name.ident), free: Vec::new(), found: false };
        hides.free.push(hides.name.clone());
        Free(&mut hides.free).visit_expr(&named.range);
        rest.iter().for_each(|stmt| hides.visit_stmt(stmt));
        hides.found |= made.names.iter().any(|own| rest.iter().any(|stmt| names(stmt, own)));
        (!hides.found).then_some((named, made.stmts))
    }

    /// Binds the values that are copied when a range is made, unless they cannot change.
    fn settle(&self, range: &mut syn::Expr, made: &mut Made<'_>) {
        match range {
            syn::Expr::Paren(it) => self.settle(&mut it.expr, made),
            syn::Expr::Range(it) => {
                it.start.iter_mut().for_each(|end| self.settle_number(end, "start", made));
                it.end.iter_mut().for_each(|end| self.settle_number(end, "end", made));
            }
            syn::Expr::MethodCall(it) => {
                self.settle(&mut it.receiver, made);
                for count in &mut it.args {
                    self.settle_number(count, "count", made);
                    // A step of zero faults there.
                    if !is_above_zero(count) {
                        made.stmts.push(parse_quote! { assert!(#count > 0); });
                    }
                }
            }
            _ => {}
        }
    }

    /// Binds a number where the range is made, unless it cannot change later.
    fn settle_number(&self, number: &mut syn::Expr, role: &str, made: &mut Made<'_>) {
        if !self.is_settled(number) {
            let name = made.fresh(role);
            made.stmts.push(parse_quote! { let #name = #number; });
            *number = parse_quote! { #name };
        }
    }

    /// Returns true if a value that a range copies cannot change later and cannot fault. A field behind a reference
    /// may change, and so may a method's result; a borrowed place may not.
    fn is_settled(&self, expr: &syn::Expr) -> bool {
        match bare(expr) {
            syn::Expr::Closure(_) | syn::Expr::Lit(_) => true,
            syn::Expr::Reference(it) => is_plain(&it.expr),
            syn::Expr::Path(it) => !self.mutable.iter().any(|name| names(&it.path, name)),
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

/// Variables for values that are computed where a range is made.
struct Made<'a> {
    /// Name of the range.
    name: &'a syn::Ident,
    /// Their `let` statements.
    stmts: Vec<syn::Stmt>,
    /// Their names.
    names: Vec<String>,
}

impl Made<'_> {
    /// Returns a name for a number, with the range's name as prefix.
    fn fresh(&mut self, role: &str) -> syn::Ident {
        let mut name = format!("{}_{role}", text(self.name));
        while self.names.contains(&name) {
            name.push('_');
        }
        self.names.push(name.clone());
        syn::Ident::new(&name, self.name.span())
    }
}

/// A range and the name that it replaces.
struct Named {
    name: syn::Ident,
    range: syn::Expr,
}

impl VisitMut for Named {
    fn visit_expr_mut(&mut self, expr: &mut syn::Expr) {
        let name = text(&self.name);
        let is_it = |expr: &syn::Expr| matches!(expr, syn::Expr::Path(it) if it.path.get_ident().is_some_and(|it| text(it) == name));
        let again = matches!(expr, syn::Expr::MethodCall(it) if it.method == "clone" && is_it(&it.receiver));
        if again || is_it(expr) {
            let range = &self.range;
            *expr = parse_quote! { (#range) };
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

/// Visitor that collects the names in a range.
struct Free<'a>(&'a mut Vec<String>);

impl<'ast> Visit<'ast> for Free<'_> {
    fn visit_expr_path(&mut self, it: &'ast syn::ExprPath) {
        self.0.extend(it.path.get_ident().map(text));
    }
}

/// Visitor that finds new meanings of a name in a range, or of its own, and uses of its own outside expressions.
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
