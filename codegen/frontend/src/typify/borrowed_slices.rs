//! Methods of slices that return references (`get`, `split_at` and the like), and patterns of slices.
//!
//! If the result is matched at once, by `let`, `if let`, `let … else` or `match`, nothing is copied: the name is an
//! alias of the place, after a test that the place exists. Elsewhere `get`, `first` and `last` return a copy, slices
//! become values ([`held_slices`](super::held_slices)), and a mutable reference is refused.

use bessemer_ir::tree::{self, Builtin, NO_SLOT, Site, SliceMethod};
use bessemer_ir::{CompareOp, Expr, ExprKind, LogicOp, Type};

use super::lengths::{compared, minus, number, plus, size};
use super::lowering::Lowering;
use super::pattern::Test;
use super::syntax::is_rest;
use super::value::{Slice, Value};
use super::words;
use super::{Needed, Result, refusals, refused};

impl Lowering<'_, '_> {
    /// Returns the slice or the reference that a method of slices returns, or the slice that an expression is; none
    /// for any other expression.
    pub(super) fn lent(&mut self, expr: &tree::Expr) -> Result<Option<Value>> {
        if let Some(option) = self.option_lent(expr)? {
            return Ok(Some(Value::Place(option)));
        }
        use SliceMethod as M;
        let (method, array, at) = match self.builtin_call(expr) {
            None | Some((Builtin::Slice(M::Whole), _)) => {
                return Ok(self.slice(expr)?.map(|slice| Value::Slice(Box::new(slice))));
            }
            Some((Builtin::Slice(method), [array, at @ ..])) if !NOT_LENT.contains(&method) => {
                (method, self.sliced(array)?, at)
            }
            Some(_) => return Ok(None),
        };
        let span = self.span(expr.site);
        let zero = Expr::usize(0, span);
        let slice = |slice: Slice| Value::Slice(Box::new(slice));
        let pair = |one, other| Value::Tuple(vec![one, other], None);
        let maybe = |there, lent| Value::Maybe(there, Box::new(lent));
        let compared = |op, one: &Expr, other: &Expr| compared(op, one, other, span);
        let length = array.length.clone();
        Ok(Some(match (method, at) {
            (M::Get | M::GetMut, [index]) => {
                let index = self.steady_index(words::INDEX, index)?;
                let there = compared(CompareOp::Lt, &index, &length);
                maybe(there, Value::Place(array.nth(index)))
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
            (M::SplitAt | M::SplitAtChecked, [at]) => {
                let at = self.steady_index("middle", at)?;
                let behind = slice(array.behind(at.clone()));
                let both = pair(slice(array.part(zero, at.clone())), behind);
                if method == M::SplitAtChecked {
                    maybe(compared(CompareOp::Le, &at, &length), both)
                } else {
                    self.check_index(&at, CompareOp::Le, &length, span);
                    both
                }
            }
            _ => {
                let (count, chunk) = match method {
                    M::SplitFirstChunk(count) | M::SplitLastChunk(count) => (count, true),
                    _ => (1, false),
                };
                let begun = size(count, span);
                let less = minus(length.clone(), begun.clone());
                let first = Value::Place(array.at(array.from.clone()));
                let last = Value::Place(array.at(minus(array.to.clone(), begun.clone())));
                let behind = slice(array.behind(begun.clone()));
                let before = slice(array.part(zero.clone(), less.clone()));
                let lent = match method {
                    M::First | M::FirstMut => first,
                    M::Last | M::LastMut => last,
                    M::SplitFirst => pair(first, behind),
                    M::SplitLast => pair(last, before),
                    M::SplitFirstChunk(_) => pair(slice(array.part(zero.clone(), begun)), behind),
                    _ => pair(before, slice(Slice { length: begun, ..array.behind(less) })),
                };
                let there = match chunk || number(&length).is_some() {
                    true => array.has(count.into(), false, span),
                    false => compared(CompareOp::Gt, &length, &zero),
                };
                maybe(there, lent)
            }
        }))
    }

    /// Evaluates an index once, into an operand that later writes do not change.
    pub(super) fn steady_index(&mut self, role: &str, index: &tree::Expr) -> Result<Expr> {
        let index = self.value(index, Some(&Type::USIZE))?;
        Ok(self.atom(role, index))
    }

    /// Returns the condition that `pattern` matches a reference that exists only if `there` is true.
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
                Ok(Test::of(there).with(inner))
            }
            tree::Pattern::Constructor(name, _) if name == "None" => {
                Ok(Test::of(Some(there.clone().negated())))
            }
            _ => refused(site, refusals::LENT),
        }
    }

    /// Returns the condition that `pattern` matches a slice.
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
            _ => return refused(site, refusals::SLICE_PATTERN),
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
                if let tree::Pattern::Name { name, slot, mutable, .. } = pattern {
                    let begun = slice.behind(Expr::usize(before as u64, span));
                    let length = minus(begun.length.clone(), Expr::usize(behind as u64, span));
                    let part = begun.part(Expr::usize(0, span), length);
                    let stands = Value::Slice(Box::new(part));
                    all = all.with(Test::named(name, *slot, stands, site).changeable(*mutable));
                }
                continue;
            } else {
                minus(slice.to.clone(), Expr::usize((patterns.len() - index) as u64, span))
            };
            all = all.with(self.test(pattern, &Value::Place(slice.at(at)), site)?);
        }
        Ok(all)
    }

    /// Returns the slice that a name refers to, if its length is a literal.
    pub(super) fn part_named(&self, expr: &tree::Expr) -> Option<Box<Slice>> {
        match self.meaning(expr)? {
            Value::Slice(part) if part.length.is_literal() => Some(part),
            _ => None,
        }
    }

    /// Lowers `*part`: copies the elements of a slice into an array.
    pub(super) fn part_value(&mut self, part: &Slice, site: Site) -> Result<Expr> {
        let len = number(&part.length)
            .and_then(|length| u32::try_from(length).ok())
            .or_refused(site, refusals::SLICE_VALUE)?;
        let ty = Type::Array { element: Box::new(part.element.clone()), len };
        Ok(part.as_array(ty, self.span(site)))
    }

    /// Binds a name to a part of a slice: as an alias, or as a copy if the name has a value type.
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
        let (value, ty) = (self.part_value(part, site)?, self.slot(slot, site)?);
        self.agree(&value.ty, &ty, site)?;
        let span = self.span(site);
        self.let_named(name, value, span);
        Ok(())
    }
}

/// Methods of slices whose result does not refer to a part of the slice.
const NOT_LENT: [SliceMethod; 6] = {
    use SliceMethod as M;
    [M::Len, M::IsEmpty, M::CopyFrom, M::Reverse, M::ToArray, M::FirstChunk]
};
