//! `for` and its sources: elements, ranges, and their adapters.
//!
//! The witness copy keeps the adapters; statements for names record their types.

use bessemer_tree as tree;
use bessemer_tree::{ExprKind, Source};
use quote::quote_spanned;
use syn::spanned::Spanned;

use super::link::{Link, gives_references, is_iter, is_source};
use super::names::{UNIT, callee_name, generating, plain, text};
use super::walk::{Lowering, see_in};
use super::{loops, refuse};

impl Lowering {
    /// Lowers a `for`; none if its bound is invalid.
    pub(super) fn for_loop(&mut self, it: &mut syn::ExprForLoop) -> Option<ExprKind> {
        let at = loops::bound_at(&it.attrs);
        let bound = self.bound(&mut it.attrs)?;
        // Of an iterator of one's own only types tell.
        let shows = is_source(&it.expr) && !is_iter(&it.expr)
            || matches!(&*it.expr, syn::Expr::Reference(it) if it.mutability.is_none());
        if let Some(at) = at.filter(|_| shows) {
            self.refusals.add(at, refuse::SHOWN_BOUND);
        }
        let label = it.label.as_ref().map(|label| text(&label.name.ident));
        let limits = it.expr.span();
        let source = Box::new(self.source(&mut it.expr));
        if matches!(&*source, Source::Numbers(it) if it.to.is_none()) && !loops::is_left(&it.body) {
            self.refusals.add(limits, refuse::OPEN_RANGE);
        }
        Some(self.scoped(|walk| {
            let mut looks = Vec::new();
            let pattern = Box::new(walk.pattern(&it.pat, &mut looks));
            let body = walk.branch(&mut it.body, false);
            it.body.stmts.splice(0..0, looks);
            ExprKind::Each { label, pattern, source, bound, body }
        }))
    }

    /// Returns the sequence of an expression in iteration.
    fn source(&mut self, expr: &mut syn::Expr) -> Source {
        if let syn::Expr::Call(_) = expr
            && let Some(other) = self.rewritten(expr)
        {
            *expr = other;
        }
        let linked = is_source(expr);
        match expr {
            syn::Expr::Paren(it) if linked => self.source(&mut it.expr),
            syn::Expr::Range(it) => Source::Numbers(self.numbers(it)),
            syn::Expr::MethodCall(it) if linked => self.linked(it),
            other => {
                let owned = !matches!(other, syn::Expr::Reference(_));
                Source::Elements(self.value(other), owned)
            }
        }
    }

    fn linked(&mut self, it: &mut syn::ExprMethodCall) -> Source {
        let (link, lent) = (Link::of(it), gives_references(&it.receiver));
        if let Some(Link::Group(way)) = link {
            let array = self.value(&mut it.receiver);
            return Source::Groups(way, array, self.value(&mut it.args[0]));
        }
        let of = Box::new(self.source(&mut it.receiver));
        match link {
            Some(Link::Enumerate) => Source::Enumerate(of),
            Some(Link::Rev) => Source::Rev(of),
            Some(Link::Cycle) => Source::Cycle(of),
            Some(Link::Skip) => Source::Skip(of, self.value(&mut it.args[0])),
            Some(Link::Take) => Source::Take(of, self.value(&mut it.args[0])),
            Some(Link::StepBy) => Source::StepBy(of, self.value(&mut it.args[0])),
            Some(Link::Zip) => self.zipped(of, &mut it.args[0]),
            Some(Link::Chain) => Source::Chain(
                of,
                match self.source(&mut it.args[0]) {
                    // What is beside references is one, whatever it is called.
                    Source::Elements(array, owned) => {
                        Box::new(Source::Elements(array, owned && !lent))
                    }
                    other => Box::new(other),
                },
            ),
            _ => match *of {
                Source::Elements(array, owned) => {
                    Source::Elements(array, owned && link == Some(Link::IntoIter))
                }
                other => other,
            },
        }
    }

    /// Returns the `zip` of two sources. The second may be an iterator though its syntax does not show it.
    fn zipped(&mut self, of: Box<Source>, with: &mut syn::Expr) -> Source {
        let shows = is_source(with) || matches!(with, syn::Expr::Reference(_));
        let other = Box::new(self.source(with));
        let next = (!shows).then(|| {
            let callee = self.callee();
            if generating() {
                let name = callee_name(callee);
                *with =
                    syn::Expr::Verbatim(quote_spanned! { with.span() => __beside(&#name, #with) });
            }
            callee
        });
        Source::Zip(of, other, next)
    }

    fn numbers(&mut self, it: &mut syn::ExprRange) -> tree::Range {
        let inclusive = matches!(it.limits, syn::RangeLimits::Closed(_));
        let (from, slot) = match &mut it.start {
            Some(start) => {
                let (from, slot) = (self.value(start), self.slot());
                see_in(slot, start);
                (from, slot)
            }
            None => {
                self.refusals.add(&it.limits, refuse::OPEN_RANGE);
                (plain(UNIT, &it.limits), tree::NO_SLOT)
            }
        };
        let to = it.end.as_mut().map(|to| self.value(to));
        tree::Range { from, to, inclusive, slot }
    }
}
