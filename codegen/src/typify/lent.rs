//! Methods of slices that return references (`get`, `split_at` and the like), and patterns of slices.
//!
//! Nothing is copied: what is lent is another name for its place, behind the test that it is there, where it is
//! taken apart where it is called, by `let`, `if let`, `let … else` or `match`. Elsewhere `get`, `first` and `last` give
//! a copy, slices become values ([`held_slices`](super::held_slices)), and what would be written is refused.

use bessemer_ir::tree::{self, Builtin, NO_SLOT, Site, SliceMethod};
use bessemer_ir::{CompareOp, Expr, ExprKind, Fault, LogicOp, Mode, Span, StmtKind, Type};

use super::elements::Slice;
use super::lengths::{minus, plus};
use super::lowering::{Binding, Lowering};
use super::regions::ENDS;
use super::subject::{Named, Subject};
use super::syntax::is_rest;
use super::{Result, problem};

impl Lowering<'_, '_> {
    /// The slice that a method of slices lends or that an expression is; none if it is neither.
    pub(super) fn lent(&mut self, expr: &tree::Expr) -> Result<Option<Subject>> {
        if let Some(option) = self.option_lent(expr)? {
            return Ok(Some(Subject::Place(option)));
        }
        let tree::ExprKind::Call(callee, arguments) = &expr.kind else {
            return Ok(self.slice(expr)?.map(|slice| Subject::Slice(Box::new(slice))));
        };
        let method = match self.builtin_of(*callee) {
            Some(Builtin::Slice(SliceMethod::Whole)) => {
                return Ok(self.slice(expr)?.map(|slice| Subject::Slice(Box::new(slice))));
            }
            Some(Builtin::Slice(method)) => method,
            _ => return Ok(None),
        };
        use SliceMethod as M;
        let span = self.span(expr.site);
        let (zero, one) = (Expr::usize(0, span), Expr::usize(1, span));
        let slice = |slice: Slice| Subject::Slice(Box::new(slice));
        Ok(Some(match (method, arguments.as_slice()) {
            (M::Get | M::GetMut, [array, index]) => {
                let array = self.sliced(array)?;
                let index = self.value(index, Some(&Type::USIZE))?;
                let index = self.steady("index", index);
                let there =
                    Expr::compare(CompareOp::Lt, index.clone(), array.length.clone()).at(span);
                let place = array.at(plus(array.from.clone(), index));
                Subject::Maybe(there, Box::new(Subject::Place(place)))
            }
            (M::GetPart, [array, from, to]) => {
                let array = self.sliced(array)?;
                let from = self.value(from, Some(&Type::USIZE))?;
                let from = self.steady(ENDS[0], from);
                let to = self.value(to, Some(&Type::USIZE))?;
                let to = self.steady("to", to);
                let inside =
                    Expr::compare(CompareOp::Le, to.clone(), array.length.clone()).at(span);
                let there = match from.kind {
                    ExprKind::Literal(0) => inside,
                    _ => {
                        let ordered =
                            Expr::compare(CompareOp::Le, from.clone(), to.clone()).at(span);
                        Expr::logic(LogicOp::And, ordered, inside)
                    }
                };
                Subject::Maybe(there, Box::new(slice(array.between(from, to))))
            }
            (M::GetFrom, [array, from]) => {
                let array = self.sliced(array)?;
                let from = self.value(from, Some(&Type::USIZE))?;
                let from = self.steady(ENDS[0], from);
                let there =
                    Expr::compare(CompareOp::Le, from.clone(), array.length.clone()).at(span);
                Subject::Maybe(there, Box::new(slice(array.behind(from))))
            }
            (
                M::First | M::FirstMut | M::Last | M::LastMut | M::SplitFirst | M::SplitLast,
                [array],
            ) => {
                let array = self.sliced(array)?;
                let there = match array.length.kind {
                    ExprKind::Literal(length) => Expr::bool(length > 0, span),
                    _ => Expr::compare(CompareOp::Gt, array.length.clone(), zero.clone()).at(span),
                };
                let less = minus(array.length.clone(), one.clone());
                let last = minus(array.to.clone(), one.clone());
                let lent = match method {
                    M::First | M::FirstMut => Subject::Place(array.at(array.from.clone())),
                    M::Last | M::LastMut => Subject::Place(array.at(last)),
                    M::SplitFirst => {
                        let first = array.at(array.from.clone());
                        Subject::Parts(vec![Subject::Place(first), slice(array.behind(one))])
                    }
                    _ => {
                        let rest = array.part(zero, less);
                        Subject::Parts(vec![Subject::Place(array.at(last)), slice(rest)])
                    }
                };
                Subject::Maybe(there, Box::new(lent))
            }
            (M::SplitFirstChunk(count) | M::SplitLastChunk(count), [array]) => {
                let array = self.sliced(array)?;
                let enough = u64::from(count);
                let count = Expr::usize(enough, span);
                let there = match array.length.kind {
                    ExprKind::Literal(length) => Expr::bool(length >= enough, span),
                    _ => Expr::compare(CompareOp::Ge, array.length.clone(), count.clone()).at(span),
                };
                let less = minus(array.length.clone(), count.clone());
                let parts = match method {
                    M::SplitFirstChunk(_) => [array.part(zero, count.clone()), array.behind(count)],
                    _ => {
                        let chunk = Slice { length: count, ..array.behind(less.clone()) };
                        [array.part(zero, less), chunk]
                    }
                };
                Subject::Maybe(there, Box::new(Subject::Parts(parts.map(slice).into())))
            }
            (M::SplitAt, [array, at]) => {
                let array = self.sliced(array)?;
                let at = self.value(at, Some(&Type::USIZE))?;
                let at = self.steady("middle", at);
                let there = Expr::compare(CompareOp::Le, at.clone(), array.length.clone()).at(span);
                self.emit(StmtKind::Check { condition: there, fault: Fault::Index }, span);
                let behind = slice(array.behind(at.clone()));
                Subject::Parts(vec![slice(array.part(zero, at)), behind])
            }
            _ => return Ok(None),
        }))
    }

    /// The condition for `pattern` to take what may be absent.
    pub(super) fn test_maybe(
        &mut self,
        pattern: &tree::Pattern,
        (there, lent): (&Expr, &Subject),
        site: Site,
        names: &mut Vec<Named>,
    ) -> Result<Option<Expr>> {
        match pattern {
            tree::Pattern::Constructor(name, parts) if name == "Some" && parts.len() == 1 => {
                let inner = self.test(&parts[0], lent, site, names)?;
                // Of an array it is known.
                let there = (there.kind != ExprKind::Literal(1)).then(|| there.clone());
                Ok(match (there, inner) {
                    (Some(there), Some(inner)) => Some(Expr::logic(LogicOp::And, there, inner)),
                    (there, inner) => there.or(inner),
                })
            }
            tree::Pattern::Constructor(name, _) if name == "None" => {
                Ok(Some(there.clone().negated()))
            }
            _ => problem(site, LENT, TAKE_APART),
        }
    }

    /// The condition for `pattern` to take a slice.
    pub(super) fn test_slice(
        &mut self,
        pattern: &tree::Pattern,
        slice: &Slice,
        site: Site,
        names: &mut Vec<Named>,
    ) -> Result<Option<Expr>> {
        let patterns = match pattern {
            tree::Pattern::Name { name, slot, inner: None, .. } => {
                names.push(Named::part(name, *slot, slice.clone(), site));
                return Ok(None);
            }
            tree::Pattern::Array(patterns) => patterns,
            _ => {
                return problem(
                    site,
                    "this pattern does not fit a slice",
                    "write `[first, .., last]`, `[first, rest @ ..]` and the like",
                );
            }
        };
        let span = slice.base.span;
        let rest = patterns.iter().position(is_rest);
        let behind = rest.map_or(0, |rest| patterns.len() - rest - 1);
        let before = patterns.len() - behind - usize::from(rest.is_some());
        let fixed = (before + behind) as u64;
        let wanted = Expr::usize(fixed, span);
        let mut all = match (rest, &slice.length.kind) {
            // rustc has counted the elements of an array.
            (_, ExprKind::Literal(_)) => None,
            (Some(_), _) if fixed == 0 => None,
            (Some(_), _) => {
                Some(Expr::compare(CompareOp::Ge, slice.length.clone(), wanted).at(span))
            }
            (None, _) => Some(Expr::compare(CompareOp::Eq, slice.length.clone(), wanted).at(span)),
        };
        for (index, pattern) in patterns.iter().enumerate() {
            let at = if index < before {
                plus(slice.from.clone(), Expr::usize(index as u64, span))
            } else if Some(index) == rest {
                if let tree::Pattern::Name { name, slot, .. } = pattern {
                    let begun = slice.behind(Expr::usize(before as u64, span));
                    let length = minus(begun.length.clone(), Expr::usize(behind as u64, span));
                    let part = begun.part(Expr::usize(0, span), length);
                    names.push(Named::part(name, *slot, part, site));
                }
                continue;
            } else {
                minus(slice.to.clone(), Expr::usize((patterns.len() - index) as u64, span))
            };
            let next = self.test(pattern, &Subject::Place(slice.at(at)), site, names)?;
            all = match (all, next) {
                (Some(all), Some(next)) => Some(Expr::logic(LogicOp::And, all, next)),
                (all, next) => all.or(next),
            };
        }
        Ok(all)
    }

    /// True for the name of a slice whose length is a literal.
    pub(super) fn is_part(&mut self, expr: &tree::Expr) -> bool {
        let tree::ExprKind::Local(name) = &expr.kind else { return false };
        let found = self.lookup(name, expr.site);
        matches!(found, Ok(Binding::Slice(part)) if part.length.is_literal())
    }

    /// `*part`: its elements as an array.
    pub(super) fn part_value(&mut self, part: &tree::Expr, site: Site) -> Result<Expr> {
        let part = self.sliced(part)?;
        let ExprKind::Literal(length) = part.length.kind else {
            return problem(site, "a slice is no value", "match what `&` refers to");
        };
        let Ok(len) = u32::try_from(length) else { return problem(site, LENT, TAKE_APART) };
        let ty = Type::Array { element: Box::new(part.element.clone()), len };
        Ok(elements_of(&part, ty, self.span(site)))
    }

    /// The name of a part: the part itself, or a copy where the author takes its value.
    pub(super) fn bind_part(
        &mut self,
        (name, slot): (&str, u32),
        part: &Slice,
        site: Site,
    ) -> Result<()> {
        if slot == NO_SLOT || self.slot_is_reference(slot, site)? {
            let part = self.kept_elements(part.clone());
            self.bind(name, Binding::Slice(Box::new(part)));
            return Ok(());
        }
        let ty = self.slot(slot, site)?;
        let (Type::Array { .. }, true) = (&ty, part.length.is_literal()) else {
            return problem(site, "a slice is no value", "match what `&` refers to");
        };
        let span: Span = self.span(site);
        let value = Some(elements_of(part, ty.clone(), span));
        let local = self.declare(name, ty, Mode::Value, span);
        self.emit(StmtKind::Let { local, value }, span);
        Ok(())
    }
}

/// A copy of the elements, of which there are as many as the type has.
fn elements_of(part: &Slice, ty: Type, span: Span) -> Expr {
    let len = if let Type::Array { len, .. } = ty { len } else { 0 };
    let element =
        |index: u32| part.at(plus(part.from.clone(), Expr::usize(u64::from(index), span))).load();
    Expr { kind: ExprKind::Array((0..len).map(element).collect()), ty, span }
}

/// The refusal of a reference that is kept.
pub(super) const LENT: &str = "what this lends is no value in the DSL";
pub(super) const TAKE_APART: &str = "take it apart where it is called: `if let Some(x) = values.get_mut(i) { … }`, `let (a, b) = values.split_at(n);`";
