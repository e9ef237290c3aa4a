//! Control flow: `if`, `match`, loops, and exits from loops.

use bessemer_tree as tree;
use bessemer_tree::ExprKind;
use quote::quote_spanned;
use syn::spanned::Spanned;

use super::names::{generating, place, site, span, text};
use super::walk::Lowering;
use super::{loops, pattern, refuse};

impl Lowering {
    pub(super) fn if_expr(&mut self, it: &mut syn::ExprIf, value: bool) -> ExprKind {
        let mut looks = Vec::new();
        let (condition, then) = self.scoped(|walk| {
            let condition = walk.condition(&mut it.cond, &mut looks);
            (condition, walk.branch(&mut it.then_branch, value))
        });
        it.then_branch.stmts.splice(0..0, looks);
        let otherwise = it.else_branch.as_mut().map(|(_, branch)| {
            let site = place(branch);
            let kind = match &mut **branch {
                syn::Expr::If(it) => self.if_expr(it, value),
                syn::Expr::Block(it) => ExprKind::Block(self.branch(&mut it.block, value)),
                other => return Box::new(self.value(other)),
            };
            Box::new(tree::Expr { kind, site, slot: None })
        });
        ExprKind::If(Box::new(condition), then, otherwise)
    }

    /// Lowers a condition, possibly with patterns: `a && let Some(x) = b`.
    fn condition(&mut self, expr: &mut syn::Expr, looks: &mut Vec<syn::Stmt>) -> tree::Expr {
        let place = place(expr);
        let kind = match expr {
            syn::Expr::Let(it) => {
                let lent = self.is_place(&it.expr);
                let value = self.value(&mut it.expr);
                pattern::brace_variants(&mut it.pat);
                ExprKind::Let(Box::new(self.pattern_of(lent, &it.pat, looks)), Box::new(value))
            }
            syn::Expr::Binary(it)
                if matches!(it.op, syn::BinOp::And(_))
                    && (has_let(&it.left) || has_let(&it.right)) =>
            {
                let mut named = Vec::new();
                let left = self.condition(&mut it.left, &mut named);
                if generating() && !named.is_empty() {
                    // What follows may borrow what has a name here.
                    let before = &it.left;
                    let seen = quote_spanned! { span(&it.left) => #before && { #(#named)* true } };
                    *it.left = syn::Expr::Verbatim(seen);
                }
                let right = self.condition(&mut it.right, looks);
                ExprKind::Binary(tree::BinaryOp::LogicAnd, Box::new(left), Box::new(right))
            }
            other => return self.value(other),
        };
        tree::Expr { kind, site: place, slot: None }
    }

    /// Lowers the guard of an arm. The arm may use the names of its patterns, so `looks` records them there.
    fn guard(&mut self, expr: &mut syn::Expr, looks: &mut Vec<syn::Stmt>) -> tree::Expr {
        match has_let(expr) {
            true => self.condition(expr, looks),
            false => self.value(expr),
        }
    }

    /// Lowers a branch of an `if`. If no value is wanted, a tail without semicolon is a statement.
    pub(super) fn branch(&mut self, block: &mut syn::Block, value: bool) -> tree::Block {
        let mut lowered = self.block(block);
        if !value && let Some(tail) = lowered.tail.take() {
            lowered.stmts.push(tree::Stmt::Expr(*tail));
        }
        lowered
    }

    pub(super) fn match_expr(&mut self, it: &mut syn::ExprMatch, value: bool) -> ExprKind {
        let named = it.arms.iter().any(|arm| names_the_whole(&arm.pat));
        let lent = self.is_place(&it.expr);
        let scrutinee = match named {
            true => self.value(&mut it.expr),
            false => self.whole(&mut it.expr),
        };
        let mut arms = Vec::new();
        for arm in &mut it.arms {
            let site = site(&arm.pat);
            arms.push(self.scoped(|walk| {
                let mut looks = Vec::new();
                pattern::brace_variants(&mut arm.pat);
                let (pattern, guard) = match &mut arm.pat {
                    syn::Pat::Guard(it) => {
                        let pattern = walk.pattern_of(lent, &it.pat, &mut looks);
                        (pattern, Some(walk.guard(&mut it.guard, &mut looks)))
                    }
                    pattern => (walk.pattern_of(lent, pattern, &mut looks), None),
                };
                let lower = if value { Lowering::value } else { Lowering::statement };
                let body = walk.in_body(&mut arm.body, lower);
                behind(&mut arm.body, looks);
                tree::Arm { pattern, guard, body, site }
            }));
        }
        ExprKind::Match(Box::new(scrutinee), arms)
    }

    pub(super) fn return_expr(&mut self, it: &mut syn::ExprReturn) -> ExprKind {
        let value = it.expr.as_mut().map(|value| Box::new(self.value(value)));
        match self.leaves.clone() {
            Some(label) => ExprKind::Break(Some(label), value),
            None => ExprKind::Return(value),
        }
    }

    /// Lowers a `while`, with the bound of its attribute if it has one.
    pub(super) fn while_loop(&mut self, it: &mut syn::ExprWhile) -> Option<ExprKind> {
        let bound = self.bound(&mut it.attrs)?;
        let label = it.label.as_ref().map(|label| text(&label.name.ident));
        let mut looks = Vec::new();
        let (condition, body) = self.scoped(|walk| {
            let condition = walk.repeated(|walk| walk.condition(&mut it.cond, &mut looks));
            (Some(Box::new(condition)), walk.branch(&mut it.body, false))
        });
        it.body.stmts.splice(0..0, looks);
        Some(ExprKind::While { label, condition, bound, body })
    }

    /// Lowers a `loop`, with the bound of its attribute if it has one.
    pub(super) fn endless_loop(&mut self, it: &mut syn::ExprLoop) -> Option<ExprKind> {
        let bound = self.bound(&mut it.attrs)?;
        let label = it.label.as_ref().map(|label| text(&label.name.ident));
        let body = self.branch(&mut it.body, false);
        Some(ExprKind::While { label, condition: None, bound, body })
    }

    /// Removes and lowers `#[bound(…)]` of a loop; the outer result is none if it is invalid. Without it the bound
    /// must be proved.
    pub(super) fn bound(
        &mut self,
        attributes: &mut Vec<syn::Attribute>,
    ) -> Option<Option<Box<tree::Expr>>> {
        let Some(attribute) = loops::take(attributes, loops::BOUND) else { return Some(None) };
        let span = attribute.path().span();
        let Ok(mut bound) = attribute.parse_args::<syn::Expr>() else {
            self.refusals.add(span, refuse::BOUND);
            return None;
        };
        let bound = self.value(&mut bound);
        if !matches!(bound.kind, ExprKind::Int(..) | ExprKind::Path(..)) {
            self.refusals.add(span, refuse::BOUND);
        }
        Some(Some(Box::new(bound)))
    }

    /// Removes `#[unroll(…)]` or `#[keep]` of a loop, and returns the unroll factor.
    pub(super) fn unrolled(&mut self, attributes: &mut Vec<syn::Attribute>) -> Option<u32> {
        let attribute = loops::take(attributes, loops::HINTS)?;
        let count = match (&attribute.meta, attribute.path().is_ident("keep")) {
            (syn::Meta::Path(_), true) => Some(1),
            (syn::Meta::List(list), false) => {
                list.parse_args::<syn::LitInt>().ok().and_then(|count| count.base10_parse().ok())
            }
            _ => None,
        };
        if !count.is_some_and(|count| (1..=64).contains(&count)) {
            self.refusals.add(attribute.path().span(), refuse::UNROLL);
        }
        count
    }

    pub(super) fn break_expr(&mut self, it: &mut syn::ExprBreak) -> ExprKind {
        let label = it.label.as_ref().map(|label| text(&label.ident));
        ExprKind::Break(label, it.expr.as_mut().map(|value| Box::new(self.value(value))))
    }
}

/// Inserts statements before the value of an arm.
fn behind(body: &mut syn::Expr, looks: Vec<syn::Stmt>) {
    if generating() && !looks.is_empty() {
        let span = span(body);
        *body = syn::Expr::Verbatim(quote_spanned! { span => { #(#looks)* #body } });
    }
}

fn has_let(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Let(_) => true,
        syn::Expr::Binary(it) => has_let(&it.left) || has_let(&it.right),
        _ => false,
    }
}

/// Returns true if a pattern binds the whole matched value.
fn names_the_whole(pattern: &syn::Pat) -> bool {
    match pattern {
        syn::Pat::Ident(it) => {
            it.subpat.is_some() || it.ident.to_string().starts_with(|it: char| it.is_lowercase())
        }
        syn::Pat::Paren(it) => names_the_whole(&it.pat),
        syn::Pat::Guard(it) => names_the_whole(&it.pat),
        syn::Pat::Or(it) => it.cases.iter().any(names_the_whole),
        _ => false,
    }
}
