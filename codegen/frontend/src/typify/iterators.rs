//! Author-defined iterators, `#[data] impl Iterator for Countdown`: a loop calls their `next` until it returns
//! `None`.
//!
//! Invariant: the builder refuses such a type if it is `Copy`. So Rust moves an iterator that a loop takes by value,
//! nothing reads its variable afterwards, and the loop mutates it in place.
//!
//! Must not know: how a loop ends, or how its end is proved ([`loops`](super::loops)).

use bessemer_ir::tree::{self, Builtin, Desugared, ExprKind as Tree, Pattern, Site, Source, Ty};
use bessemer_ir::{Expr, ExprKind, Mode, Place, Type};

use super::by_hand::{is_next, taking_next};
use super::closure_args::is_hidden;
use super::each::Each;
use super::lowering::{Lowering, local_since};
use super::seq::pair;
use super::slots::result_of;
use super::syntax::bare;
use super::value::Value;
use super::{Context, Problem, Result, loops, names, refusals, words};

/// Message for a loop over such an iterator without a proved bound.
const UNBOUNDED: &str = "this loop has no known bound: its iterator can return any number of items";

/// Remedy for a loop of the author's.
const BOUND: &str = "write `#[bound(64)]` above the loop, which makes any further pass a fault; or limit the items: `it.take(64)`; or zip a finite iterator with it: `values.iter().zip(it)`";
/// Remedy for the loop of an iterator chain.
const TAKE: &str = "limit the items directly after the iterator, `it.take(64)`, before other adapters; or zip a finite iterator with it: `values.iter().zip(it)`";

/// Source of a loop that contains an author-defined iterator.
enum Own<'e> {
    /// The iterator alone: the callee of its `next`, and the iterator.
    Alone(u32, &'e tree::Expr),
    /// The iterator as the second side of a `zip`: the first side, then the callee of `next`, then the iterator.
    Beside(&'e Source, u32, &'e tree::Expr),
    /// Items with a number, as by `enumerate`.
    Numbered(Box<Own<'e>>),
}

impl<'a> Context<'a> {
    /// Records an author-defined iterator.
    pub(super) fn note_iterator(&mut self, it: &'a tree::Implied) {
        if let Ty::Named(path) = &it.owner
            && let Some(ty) = self.types.by_path.get(path)
        {
            if *ty == Type::Unit
                && let Some(next) = self.calls.all.get(it.function.as_str()).copied()
            {
                let (message, help) = refusals::EMPTY_ITERATOR;
                let (message, help) = (message.to_owned(), help.to_owned());
                self.tell(&next.file, Problem { site: next.tree.site, message, help });
                return;
            }
            let ty = ty.clone();
            let next = self.unnamed(&it.function);
            self.implied.iterators.push((ty, next));
        }
    }

    /// True for the type of an own iterator, and for an array or struct that contains one. A loop mutates such a value even if its
    /// binding is not `mut`.
    pub(super) fn holds_iterator(&self, ty: &Type) -> bool {
        match ty {
            _ if self.implied.iterators.is_empty() => false,
            Type::Array { element, .. } => self.holds_iterator(element),
            Type::Struct(id) => {
                self.implied.iterators.iter().any(|(own, _)| own == ty)
                    || self.fields(*id).iter().any(|field| self.holds_iterator(&field.ty))
            }
            _ => false,
        }
    }
}

impl Lowering<'_, '_> {
    /// Rewrites `iterator.next()` of an author-defined iterator as a call of its function.
    pub(super) fn own_next_called(&mut self, expr: &tree::Expr) -> Option<tree::Expr> {
        if self.cx.implied.iterators.is_empty() {
            return None;
        }
        let (function, [iterator]) = self.called(expr)? else { return None };
        if !is_next(function) {
            return None;
        }
        Some(tree::Expr { kind: calling(self.own_next(iterator)?, iterator.clone()), ..*expr })
    }

    /// Returns the callee that yields the next item of an expression; none if it is no author-defined iterator.
    pub(super) fn own_next(&mut self, expr: &tree::Expr) -> Option<u32> {
        if self.cx.implied.iterators.is_empty() {
            return None;
        }
        let of = self.itself(expr);
        let ty = match &of.kind {
            Tree::Local(_) => {
                let (meaning, span) = (self.meaning(of)?, self.span(of.site));
                self.place_of(&meaning, span)?.ty
            }
            Tree::Field(base, _) | Tree::Index(base, _) if self.is_of_place(base) => {
                self.place_type(of).ok()?
            }
            _ => {
                let called = self.called(of).and_then(|(it, _)| result_of(it));
                match called.or_else(|| self.seen_as(of))? {
                    Ty::Named(path) => self.cx.types.by_path.get(path)?.clone(),
                    Ty::Ref(inner, _) => match &**inner {
                        Ty::Named(path) => self.cx.types.by_path.get(path)?.clone(),
                        _ => return None,
                    },
                    _ => return None,
                }
            }
        };
        self.cx.implied.iterators.iter().find(|(own, _)| *own == ty).map(|(_, next)| *next)
    }

    /// The operand of `&`, `*` and `by_ref()`, which all denote the same iterator.
    fn itself<'e>(&self, expr: &'e tree::Expr) -> &'e tree::Expr {
        match self.builtin_call(bare(expr)) {
            Some((Builtin::Desugared(Desugared::ByRef), [of])) => self.itself(of),
            _ => bare(expr),
        }
    }

    /// Returns true for a field or an element of a variable that has a place.
    fn is_of_place(&mut self, expr: &tree::Expr) -> bool {
        match &bare(expr).kind {
            Tree::Field(base, _) | Tree::Index(base, _) => self.is_of_place(base),
            _ => {
                let span = self.span(expr.site);
                self.meaning(expr).is_some_and(|it| self.place_of(&it, span).is_some())
            }
        }
    }

    /// Returns the place of an author-defined iterator, which is mutated there.
    pub(super) fn own_iterator(&mut self, expr: &tree::Expr) -> Result<Place> {
        let (of, before) = (self.itself(expr), self.locals.len());
        let place = match self.place(of)? {
            Some(place) => {
                match self.locals[place.root.index()].mode {
                    // A value was copied from there.
                    Mode::Ref => self.iterator_copy(place.load()),
                    _ => place,
                }
            }
            None => {
                let value = self.value(of, None)?;
                match &value.kind {
                    ExprKind::Load(place) if local_since(place, before).is_some() => place.clone(),
                    _ => self.iterator_copy(value),
                }
            }
        };
        let root = place.root;
        self.locals.note_written(root);
        Ok(place)
    }

    /// Copies an author-defined iterator into a local named after its type.
    pub(super) fn iterator_copy(&mut self, value: Expr) -> Place {
        let name = match &value.ty {
            Type::Struct(id) => names::role(&self.cx.module.structs[id.index()].name),
            _ => words::ELEMENTS.into(),
        };
        self.naming_as("", |inner| inner.mutable_place(&name, value))
    }

    /// Lowers a loop over an author-defined iterator; returns false for another source.
    pub(super) fn each_of_own(&mut self, each: Each) -> Result<bool> {
        let Some(own) = self.own_source(each.source) else { return Ok(false) };
        self.naming_scope(|inner| inner.own_loop(own, each))?;
        Ok(true)
    }

    fn own_source<'e>(&mut self, source: &'e Source) -> Option<Own<'e>> {
        match source {
            Source::Elements(of, _) => Some(Own::Alone(self.own_next(of)?, of)),
            Source::Zip(one, other, _) => match &**other {
                Source::Elements(of, _) => Some(Own::Beside(one, self.own_next(of)?, of)),
                _ => None,
            },
            Source::Enumerate(of) => Some(Own::Numbered(Box::new(self.own_source(of)?))),
            _ => None,
        }
    }

    fn own_loop(&mut self, own: Own<'_>, each: Each) -> Result<()> {
        let Each { site, label, pattern, bound, body, .. } = each;
        let plain = |kind| tree::Expr::plain(kind, site);
        let some = |pattern: &Pattern| {
            Box::new(Pattern::Constructor("Some".into(), vec![pattern.clone()]))
        };
        match own {
            Own::Alone(callee, of) => {
                let next = self.next_item(callee, of, site)?;
                let Some(bound) = bound else {
                    // The loop of a chain is no `for` of the author's.
                    let hidden = matches!(pattern, Pattern::Name { name, .. } if is_hidden(name));
                    let written = self.expanding.is_empty() && !hidden;
                    let looped = self.while_stmt(
                        site,
                        label,
                        (None, None),
                        &taking_next(pattern, next, body, site),
                        None,
                    );
                    return looped.map_err(|mut problem| {
                        if problem.help == loops::DECLARE {
                            problem.message = UNBOUNDED.into();
                            problem.help = if written { BOUND } else { TAKE }.into();
                        }
                        problem
                    });
                };
                let condition = plain(Tree::Let(some(pattern), Box::new(next)));
                self.while_stmt(site, label, (Some(&condition), Some(bound)), body, None)
            }
            Own::Beside(source, callee, of) => {
                let [pattern, item] = pair(pattern, site)?;
                // Rust evaluates the operands of `zip` from left to right.
                let mut source = source.clone();
                self.create_source(&mut source)?;
                let next = self.next_item(callee, of, site)?;
                let (source, body) = (&source, &taking_next(item, next, body, site));
                self.each_stmt(Each { pattern, source, body, ..each })
            }
            Own::Numbered(own) => {
                let [number, pattern] = pair(pattern, site)?;
                let mut body = body.clone();
                self.count_items(number, &mut body, site)?;
                self.own_loop(*own, Each { pattern, body: &body, ..each })
            }
        }
    }

    /// Binds an iterator to a name, and returns the call that yields its next item.
    fn next_item(&mut self, callee: u32, of: &tree::Expr, site: Site) -> Result<tree::Expr> {
        let place = self.own_iterator(of)?;
        let known = self.scopes.len();
        let name = format!("iterator%{known}");
        self.bind(&name, Value::Place(place));
        Ok(tree::Expr::plain(calling(callee, tree::Expr::local(&name, site)), site))
    }
}

/// Returns a call of an iterator's `next`.
fn calling(callee: u32, iterator: tree::Expr) -> Tree {
    let site = iterator.site;
    let lent = tree::Expr::plain(Tree::Ref(true, Box::new(iterator)), site);
    Tree::Call(callee, vec![lent])
}
