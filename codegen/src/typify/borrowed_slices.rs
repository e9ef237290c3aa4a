//! Methods of slices that return references (`get`, `split_at` and the like), and patterns of slices.
//!
//! Nothing is copied: what is lent is another name for its place, behind the test that it is there, where it is
//! taken apart where it is called, by `let`, `if let`, `let … else` or `match`. Elsewhere `get`, `first` and `last` give
//! a copy, slices become values ([`held_slices`](super::held_slices)), and what would be written is refused.

use bessemer_ir::tree::{self, Builtin, NO_SLOT, Site, SliceMethod};
use bessemer_ir::{CompareOp, Expr, ExprKind, Fault, LogicOp, Mode, Span, StmtKind, Type};

use super::lengths::{minus, plus};
use super::lowering::Lowering;
use super::pattern::Test;
use super::syntax::is_rest;
use super::value::{Slice, Value};
use super::words;
use super::{Result, problem};

impl Lowering<'_, '_> {
    /// The slice that a method of slices lends or that an expression is; none if it is neither.
    pub(super) fn lent(&mut self, expr: &tree::Expr) -> Result<Option<Value>> {
        if let Some(option) = self.option_lent(expr)? {
            return Ok(Some(Value::Place(option)));
        }
        use SliceMethod as M;
        let (method, array, at) = match self.builtin_call(expr) {
            None | Some((Builtin::Slice(M::Whole), _)) => {
                return Ok(self.slice(expr)?.map(|slice| Value::Slice(Box::new(slice))));
            }
            Some((Builtin::Slice(method), [array, at @ ..])) if lends(method) => {
                (method, self.sliced(array)?, at)
            }
            Some(_) => return Ok(None),
        };
        let span = self.span(expr.site);
        let (zero, one) = (Expr::usize(0, span), Expr::usize(1, span));
        let slice = |slice: Slice| Value::Slice(Box::new(slice));
        let pair = |one, other| Value::Tuple(vec![one, other], None);
        let maybe = |there, lent| Value::Maybe(there, Box::new(lent));
        let compared =
            |op, one: &Expr, other: &Expr| Expr::compare(op, one.clone(), other.clone()).at(span);
        let length = array.length.clone();
        let has = |count: u32| array.has(count.into(), false, span);
        Ok(Some(match (method, at) {
            (M::Get | M::GetMut, [index]) => {
                let index = self.steady_index(words::INDEX, index)?;
                let there = compared(CompareOp::Lt, &index, &length);
                maybe(there, Value::Place(array.at(plus(array.from.clone(), index))))
            }
            (M::GetPart, [from, to]) => {
                let from = self.steady_index(words::ENDS[0], from)?;
                let to = self.steady_index("to", to)?;
                let inside = compared(CompareOp::Le, &to, &length);
                let there = match from.kind {
                    ExprKind::Literal(0) => inside,
                    _ => Expr::logic(LogicOp::And, compared(CompareOp::Le, &from, &to), inside),
                };
                maybe(there, slice(array.between(from, to)))
            }
            (M::GetFrom, [from]) => {
                let from = self.steady_index(words::ENDS[0], from)?;
                maybe(compared(CompareOp::Le, &from, &length), slice(array.behind(from)))
            }
            (M::SplitAt, [at]) => {
                let at = self.steady_index("middle", at)?;
                let condition = compared(CompareOp::Le, &at, &length);
                self.emit(StmtKind::Check { condition, fault: Fault::Index }, span);
                let behind = slice(array.behind(at.clone()));
                pair(slice(array.part(zero, at)), behind)
            }
            (M::SplitFirstChunk(count), _) => {
                let begun = Expr::usize(u64::from(count), span);
                let chunk = slice(array.part(zero.clone(), begun.clone()));
                maybe(has(count), pair(chunk, slice(array.behind(begun))))
            }
            (M::SplitLastChunk(count), _) => {
                let count_of = Expr::usize(u64::from(count), span);
                let less = minus(length.clone(), count_of.clone());
                let chunk = Slice { length: count_of, ..array.behind(less.clone()) };
                maybe(has(count), pair(slice(array.part(zero.clone(), less)), slice(chunk)))
            }
            _ => {
                let first = Value::Place(array.at(array.from.clone()));
                let last = Value::Place(array.at(minus(array.to.clone(), one.clone())));
                let less = minus(length.clone(), one.clone());
                let lent = match method {
                    M::First | M::FirstMut => first,
                    M::Last | M::LastMut => last,
                    M::SplitFirst => pair(first, slice(array.behind(one))),
                    _ => pair(last, slice(array.part(zero.clone(), less))),
                };
                let there = match length.kind {
                    ExprKind::Literal(_) => has(1),
                    _ => compared(CompareOp::Gt, &length, &zero),
                };
                maybe(there, lent)
            }
        }))
    }

    /// An index that is computed once.
    pub(super) fn steady_index(&mut self, role: &str, index: &tree::Expr) -> Result<Expr> {
        let index = self.value(index, Some(&Type::USIZE))?;
        Ok(self.steady(role, index))
    }

    /// The condition for `pattern` to take what may be absent.
    pub(super) fn test_maybe(
        &mut self,
        pattern: &tree::Pattern,
        (there, lent): (&Expr, &Value),
        site: Site,
    ) -> Result<Test> {
        match pattern {
            tree::Pattern::Constructor(name, parts) if name == "Some" && parts.len() == 1 => {
                let inner = self.test(&parts[0], lent, site)?;
                // Of an array it is known.
                let there = (there.kind != ExprKind::Literal(1)).then(|| there.clone());
                Ok(Test::of(there).and(inner))
            }
            tree::Pattern::Constructor(name, _) if name == "None" => {
                Ok(Test::of(Some(there.clone().negated())))
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
    ) -> Result<Test> {
        let patterns = match pattern {
            tree::Pattern::Name { name, slot, inner: None, .. } => {
                let stands = Value::Slice(Box::new(slice.clone()));
                return Ok(Test::named(name, *slot, stands, site));
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
        // rustc has counted the elements of an array, and not those of `&values[3..]`.
        let there = slice.has(fixed, rest.is_none(), span);
        let always = there.kind == ExprKind::Literal(1) || (rest.is_some() && fixed == 0);
        let mut all = Test::of((!always).then_some(there));
        for (index, pattern) in patterns.iter().enumerate() {
            let at = if index < before {
                plus(slice.from.clone(), Expr::usize(index as u64, span))
            } else if Some(index) == rest {
                if let tree::Pattern::Name { name, slot, .. } = pattern {
                    let begun = slice.behind(Expr::usize(before as u64, span));
                    let length = minus(begun.length.clone(), Expr::usize(behind as u64, span));
                    let part = begun.part(Expr::usize(0, span), length);
                    let stands = Value::Slice(Box::new(part));
                    all = all.and(Test::named(name, *slot, stands, site));
                }
                continue;
            } else {
                minus(slice.to.clone(), Expr::usize((patterns.len() - index) as u64, span))
            };
            all = all.and(self.test(pattern, &Value::Place(slice.at(at)), site)?);
        }
        Ok(all)
    }

    /// True for the name of a slice whose length is a literal.
    pub(super) fn is_part(&mut self, expr: &tree::Expr) -> bool {
        let tree::ExprKind::Local(name) = &expr.kind else { return false };
        let found = self.lookup(name, expr.site);
        matches!(found, Ok(Value::Slice(part)) if part.length.is_literal())
    }

    /// `*part`: its elements as an array.
    pub(super) fn part_value(&mut self, part: &tree::Expr, site: Site) -> Result<Expr> {
        let part = self.sliced(part)?;
        let ExprKind::Literal(length) = part.length.kind else {
            return problem(site, "a slice is no value", "match what `&` refers to");
        };
        let Ok(len) = u32::try_from(length) else { return problem(site, LENT, TAKE_APART) };
        let ty = Type::Array { element: Box::new(part.element.clone()), len };
        Ok(part.as_array(ty, self.span(site)))
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
            self.bind(name, Value::Slice(Box::new(part)));
            return Ok(());
        }
        let ty = self.slot(slot, site)?;
        let (Type::Array { .. }, true) = (&ty, part.length.is_literal()) else {
            return problem(site, "a slice is no value", "match what `&` refers to");
        };
        let span: Span = self.span(site);
        let value = Some(part.as_array(ty.clone(), span));
        let local = self.declare(name, ty, Mode::Value, span);
        self.emit(StmtKind::Let { local, value }, span);
        Ok(())
    }
}

/// Whether a method lends a part of its slice.
fn lends(method: SliceMethod) -> bool {
    use SliceMethod as M;
    matches!(
        method,
        M::Get
            | M::GetMut
            | M::GetPart
            | M::GetFrom
            | M::First
            | M::FirstMut
            | M::Last
            | M::LastMut
            | M::SplitFirst
            | M::SplitLast
            | M::SplitFirstChunk(_)
            | M::SplitLastChunk(_)
            | M::SplitAt
    )
}

/// The refusal of a reference that is kept.
pub(super) const LENT: &str = "what this lends is no value in the DSL";
pub(super) const TAKE_APART: &str = "take it apart where it is called: `if let Some(x) = values.get_mut(i) { … }`, `let (a, b) = values.split_at(n);`";
