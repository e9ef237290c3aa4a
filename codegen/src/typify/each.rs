//! `for` over the elements of arrays and matrices: a `for` over their indices.
//!
//! A name for a reference is another name for the element; a name for a value is a local of its own.

use std::rc::Rc;

use bessemer_ir::tree::{self, Grouping, Order, Site};
use bessemer_ir::{
    BinaryOp, Block, CompareOp, Expr, ExprKind, Fault, Intrinsic, Local, LocalId, Mode, Place,
    Span, Step, Stmt, StmtKind, Type,
};

use super::elements::Slice;
use super::lengths::{divided, greatest, is_number, least, lesser, minus, plus, same, times};
use super::lowering::Lowering;
use super::numbered::{Numbered, with_elements};
use super::value::Value;
use super::words;
use super::{Result, problem};
use crate::effects;

impl Lowering<'_, '_> {
    pub(super) fn each_stmt(
        &mut self,
        site: Site,
        (label, index): (Option<&str>, Option<&str>),
        parts: &[tree::Part],
        (order, cuts): (Order, &[tree::Cut]),
        body: &tree::Block,
    ) -> Result<()> {
        let span = self.span(site);
        if let Some(generated) = self.generated(parts)? {
            return self.generated_stmt(site, (label, index), generated, (order, cuts), body);
        }
        if let ([part], None, Order::Up, []) = (parts, index, order, cuts) {
            if let Some(matrix) = self.bounded_place(&part.array) {
                return self.each_of_bounded(site, label, (part, matrix), body);
            }
            if part.group.is_none() && self.may_be_there(&part.array) {
                return self.one_pass(site, label, part, body);
            }
        }
        let (mut slices, mut variables) = (Vec::new(), Vec::new());
        let mut numbers = Vec::new();
        for part in parts {
            if let Some(found) = self.numbers(part, slices.len())? {
                numbers.push(found);
                continue;
            }
            let (passed, variable) = match self.iterator_named(&part.array) {
                Some(named) => {
                    let named = Rc::clone(&self.closures[named]);
                    let own = elements_through(&named.text).unwrap_or(part).clone();
                    self.in_scope_of(&named, None, site, |inner| {
                        Ok((inner.passed(&own)?, inner.variable(&own.array)))
                    })?
                }
                None => (self.passed(part)?, self.variable(&part.array)),
            };
            if let Some(passed) = passed {
                slices.push(passed);
                variables.push(variable);
            }
        }
        let parts = &*with_elements(parts);
        let around = |it: &Passed| matches!(it.group, Some((Grouping::Around, _)));
        if let Some(at) = slices.iter().position(around) {
            // Then both end with the other sequence, and neither is empty where the other is not.
            let (around_it, its_variable) = (&slices[at], &variables[at]);
            let is_same = |(it, variable): (&Passed, &Option<_>)| {
                let (one, other) = (&it.slice, &around_it.slice);
                let is_same_slice = effects::same_place(&one.base, &other.base)
                    && same(&one.from, &other.from)
                    && same(&one.to, &other.to);
                let is_same_variable = variable.is_some() && variable == its_variable;
                same(&it.count, &around_it.count) || is_same_slice || is_same_variable
            };
            let mut others = slices.iter().zip(&variables).filter(|(it, _)| !around(it));
            if !others.any(is_same) {
                return problem(
                    parts[at].array.site,
                    "`.cycle()` stands beside a loop through the same elements in the DSL",
                    "index instead: `values[i % values.len()]`",
                );
            }
        }
        // The counter is the index of the array itself, where nothing else is asked of it.
        let bare =
            index.is_none() && numbers.is_empty() && order != Order::Mirrored && cuts.is_empty();
        let (from, end) = match slices.as_slice() {
            [Passed { slice, group: None, behind, .. }] if bare && behind.is_empty() => {
                (slice.from.clone(), slice.to.clone())
            }
            slices => {
                let all = (Expr::usize(0, span), shortest(slices, span));
                self.cut_off(all, cuts)?
            }
        };
        let counts = slices.iter().map(|it| it.count.clone()).collect();
        let most = slices.iter().filter_map(Passed::most).min();
        let numbered = self.numbered(numbers, (counts, most), (cuts, body))?;
        let last = minus(end.clone(), Expr::usize(1, span));
        let reversed = order == Order::Down;
        let mut copies = Vec::new();
        let mut lowered = |inner: &mut Self| {
            let variable = LocalId(inner.locals.len() as u32);
            let name = index.unwrap_or_else(|| inner.next_index(&numbered)).to_owned();
            inner.counters.push(variable);
            inner.locals.push(Local { name, ty: Type::USIZE, mode: Mode::Value, span });
            let mut block = inner.scoped(|inner| {
                if let Some(index) = index {
                    inner.bind(index, Value::Local(variable));
                }
                let counter = Place::local(variable, Type::USIZE, span).load();
                let counter = match order {
                    Order::Mirrored => minus(last.clone(), counter),
                    _ => counter,
                };
                inner.number_pass(&numbered, &counter, site)?;
                for (part, passed) in parts.iter().zip(&slices) {
                    inner.name_pass(
                        part,
                        passed,
                        counter.clone(),
                        bare && slices.len() == 1,
                        site,
                    )?;
                }
                inner.statements(body)
            })?;
            let places: Vec<_> = slices.iter().map(|passed| passed.slice.base.clone()).collect();
            copies = inner.copy_written(parts, &places, &mut block, span);
            inner.counters.pop();
            let (from, to) = (from.clone(), end.clone());
            Ok(StmtKind::For {
                variable,
                from,
                to,
                inclusive: numbered.over,
                reversed,
                unroll: None,
                ended: false,
                body: block,
            })
        };
        let mark = self.out.len();
        self.repeated(label, None, span, &mut lowered)?;
        self.out.splice(mark..mark, copies);
        Ok(())
    }

    /// The variable that a sequence is, or is a field of: a local, and the fields on the way.
    fn variable(&self, array: &tree::Expr) -> Option<(LocalId, Vec<String>)> {
        match &array.kind {
            tree::ExprKind::Local(name) => match self.lookup(name, array.site).ok()? {
                Value::Local(root) => Some((root, Vec::new())),
                Value::Place(place) if place.steps.is_empty() => Some((place.root, Vec::new())),
                _ => None,
            },
            tree::ExprKind::Field(base, name) => {
                let (root, mut fields) = self.variable(base)?;
                fields.push(name.clone());
                Some((root, fields))
            }
            _ => None,
        }
    }

    /// What passes get of a part.
    fn passed(&mut self, part: &tree::Part) -> Result<Option<Passed>> {
        let mut chained = self.chained(&part.array)?.into_iter();
        let Some(slice) = chained.next() else { return Ok(None) };
        let passed = Passed::of(slice, self.group_size(part.group.as_ref())?);
        Ok(Some(passed.and(chained.collect())))
    }

    /// The sequences of a loop, one after the other.
    fn chained(&mut self, array: &tree::Expr) -> Result<Vec<Slice>> {
        if let tree::ExprKind::Chain(one, other) = &array.kind {
            let mut slices = self.chained(one)?;
            slices.extend(self.chained(other)?);
            return Ok(slices);
        }
        if let Some(part) = self.submatrix(array)? {
            return Ok(vec![part.elements()]);
        }
        Ok(vec![match self.slice(array)? {
            Some(slice) => slice,
            None => self.elements_of(array)?,
        }])
    }

    /// The element of a pass through several arrays, in a local of its own.
    fn one_of_several(
        &mut self,
        part: &tree::Part,
        passed: &Passed,
        counter: Expr,
    ) -> Result<Place> {
        let (first, span) = (&passed.slice, counter.span);
        let name = match &part.pattern {
            tree::Pattern::Name { name, .. } => name.as_str(),
            _ => words::ELEMENT,
        };
        let (local, ty) = (LocalId(self.locals.len() as u32), first.element.clone());
        self.locals.push(Local { name: name.to_owned(), ty: ty.clone(), mode: Mode::Value, span });
        self.held.insert(local);
        let place = Place::local(local, ty, span);
        self.emit(StmtKind::Let { local, value: None }, span);
        let mut cases = Vec::new();
        let mut counter = counter;
        for slice in std::iter::once(first).chain(&passed.behind) {
            let element = slice.at(plus(slice.from.clone(), counter.clone())).load();
            let assign = StmtKind::Assign { place: place.clone(), value: element };
            cases.push((is_below(&counter, &slice.length), assign));
            counter = minus(counter, slice.length.clone());
        }
        let mut last = None;
        for (condition, kind) in cases.into_iter().rev() {
            let then = Block(vec![Stmt { kind, span, comments: Vec::new() }]);
            last = Some(match last {
                None => then,
                Some(otherwise) => {
                    let kind = StmtKind::If { condition, then, otherwise };
                    Block(vec![Stmt { kind, span, comments: Vec::new() }])
                }
            });
        }
        self.out.extend(last.unwrap_or_default().0);
        Ok(place)
    }

    /// All elements of what a loop goes through.
    fn elements_of(&mut self, expr: &tree::Expr) -> Result<Slice> {
        let mut place = self.base(expr)?;
        // Whether there is a pass or not.
        self.fix(&mut place);
        let bounded = self.bounded_type(&place.ty).is_some();
        match self.all_of(place) {
            Some(slice) => Ok(slice),
            None if bounded => problem(
                expr.site,
                "all elements of a `BoundedMatrix` are gone through by themselves, and from the first on",
                "give the matrix a name; or write `for column in 0..m.ncols()`, and index",
            ),
            None => problem(
                expr.site,
                "a loop goes through arrays and vectors in the DSL",
                "write `for i in 0..n`, and index",
            ),
        }
    }

    /// Computes the indices on the way to an array once.
    pub(super) fn held_still(&mut self, mut place: Place) -> Place {
        for step in &mut place.steps {
            if let Step::Index(index) = step
                && !index.is_literal()
                && !self.is_counter(index)
                && !self.is_steady(index)
            {
                *index = self.temporary(words::INDEX, index.clone());
            }
        }
        place
    }

    /// Whether a value is that of a counter, which only its loop changes.
    fn is_counter(&self, index: &Expr) -> bool {
        matches!(&index.kind, ExprKind::Load(place)
            if place.steps.is_empty() && self.counters.contains(&place.root))
    }

    /// The name for the counter of a loop whose author has none.
    fn next_index(&self, numbered: &Numbered) -> &'static str {
        let names = words::COUNTERS;
        if let Some(name) =
            names.iter().find(|it| !numbered.named(it)).filter(|it| **it != names[0])
        {
            return name;
        }
        let taken =
            self.counters.iter().filter(|id| names.contains(&&*self.locals[id.index()].name));
        names[taken.count() % names.len()]
    }

    /// Names what a pass gets of one of the parts.
    fn name_pass(
        &mut self,
        part: &tree::Part,
        passed: &Passed,
        counter: Expr,
        bare: bool,
        site: Site,
    ) -> Result<()> {
        let slice = &passed.slice;
        if !passed.behind.is_empty() {
            let element = self.one_of_several(part, passed, counter)?;
            let mut names = Vec::new();
            self.test(&part.pattern, &Value::Place(element), site, &mut names)?;
            return self.bind_names(&names);
        }
        let Some((way, size)) = &passed.group else {
            let at = match (bare, part.reversed) {
                (true, false) => counter,
                (_, false) => plus(slice.from.clone(), counter),
                (_, true) => {
                    minus(minus(slice.to.clone(), Expr::usize(1, slice.base.span)), counter)
                }
            };
            let mut names = Vec::new();
            self.test(&part.pattern, &Value::Place(slice.at(at)), site, &mut names)?;
            return self.bind_names(&names);
        };
        let size = size.clone().at(slice.base.span);
        if *way == Grouping::Around {
            let at = plus(counter, size);
            let at = Expr::binary(BinaryOp::Rem, at, slice.length.clone());
            let at = plus(slice.from.clone(), at);
            let mut names = Vec::new();
            self.test(&part.pattern, &Value::Place(slice.at(at)), site, &mut names)?;
            return self.bind_names(&names);
        }
        let begin = match way {
            Grouping::Windows => counter,
            _ if size.is_literal() => times(counter, size.clone()),
            // Each begins within the sequence.
            _ => Expr::intrinsic(Intrinsic::WrappingMul, vec![counter, size.clone()]),
        };
        if *way == Grouping::First {
            let at = match part.reversed {
                false => plus(slice.from.clone(), begin),
                true => minus(minus(slice.to.clone(), Expr::usize(1, slice.base.span)), begin),
            };
            let mut names = Vec::new();
            self.test(&part.pattern, &Value::Place(slice.at(at)), site, &mut names)?;
            return self.bind_names(&names);
        }
        match &part.pattern {
            tree::Pattern::Any => {}
            // They are not one behind the other.
            tree::Pattern::Name { .. } if slice.within.is_some() => return Self::moved_part(site),
            tree::Pattern::Name { name, inner: None, .. } => {
                let part = match (way, &slice.length.kind) {
                    (Grouping::All, ExprKind::Literal(_)) => {
                        let end = least(plus(begin.clone(), size), slice.length.clone());
                        let end = self.steady("end", end);
                        slice.between(begin, end)
                    }
                    (Grouping::All, _) => {
                        let left = least(size, minus(slice.length.clone(), begin.clone()));
                        let length = self.steady("length", left);
                        slice.part(begin, length)
                    }
                    _ => slice.part(begin, size),
                };
                self.bind(name, Value::Slice(Box::new(part)));
            }
            _ => {
                return problem(
                    site,
                    "a window is not taken apart in the DSL",
                    "give it a name, and index it",
                );
            }
        }
        Ok(())
    }

    /// How many elements a pass gets: a literal, or a local that is not zero.
    fn group_size(&mut self, group: Option<&tree::Group>) -> Result<Option<(Grouping, Expr)>> {
        let Some(group) = group else { return Ok(None) };
        if group.way == Grouping::Around {
            let first = self.value(&group.size, Some(&Type::USIZE))?;
            if self.known(&first).is_none_or(|first| first > u64::from(u32::MAX)) {
                return problem(
                    group.size.site,
                    "the number of the first element is known when the C is written, in the DSL",
                    "write a number: `values.iter().cycle().skip(1)`",
                );
            }
            return Ok(Some((group.way, first)));
        }
        let size = self.value(&group.size, Some(&Type::USIZE))?;
        let span = size.span;
        let size = match self.known(&size) {
            Some(0) => {
                return problem(
                    group.size.site,
                    "no elements at a time never come to an end",
                    "write a number above 0",
                );
            }
            Some(word) => Expr::usize(word, span),
            None => {
                let size = self.steady("size", size);
                let condition = Expr::compare(CompareOp::Ne, size.clone(), Expr::usize(0, span));
                self.emit(StmtKind::Check { condition, fault: Fault::Assertion }, span);
                size
            }
        };
        Ok(Some((group.way, size)))
    }

    /// The ends of the way, after `.skip(n)` and `.take(n)`.
    fn cut_off(&mut self, (from, to): (Expr, Expr), cuts: &[tree::Cut]) -> Result<(Expr, Expr)> {
        let (mut from, mut to) = (from, to);
        for cut in cuts {
            let count = self.value(&cut.count, Some(&Type::USIZE))?;
            // No more were taken than there are.
            if self.is_taken(&count) && is_number(&from, 0) {
                from = count;
                continue;
            }
            let count = least(count, minus(to.clone(), from.clone()));
            let count = self.steady("count", count);
            match (cut.skip, cut.back) {
                (true, false) => from = plus(from, count),
                (false, false) => to = plus(from.clone(), count),
                (true, true) => to = minus(to, count),
                (false, true) => from = minus(to.clone(), count),
            }
        }
        Ok((from, to))
    }

    /// Whether the elements are references, whatever they are gone through by: those of a slice with a name.
    fn refers(&self, part: &tree::Part) -> bool {
        let tree::Pattern::Name { slot, .. } = &part.pattern else { return false };
        matches!(self.source.slots.get(*slot as usize), Some(tree::Ty::Ref(..)))
    }

    /// A loop over a value does not see what its body writes: then it goes through a copy. Gives the
    /// declarations of the copies.
    fn copy_written(
        &mut self,
        parts: &[tree::Part],
        places: &[Place],
        body: &mut Block,
        span: Span,
    ) -> Vec<Stmt> {
        let mut copies = Vec::new();
        for (part, place) in parts.iter().zip(places) {
            if !part.owned || self.refers(part) || !effects::writes_local(body, place.root) {
                continue;
            }
            let copy = LocalId(self.locals.len() as u32);
            let ty = place.ty.clone();
            self.locals.push(Local {
                name: words::ELEMENTS.into(),
                ty: ty.clone(),
                mode: Mode::Value,
                span,
            });
            let mut copied = false;
            for stmt in &mut body.0 {
                // The declarations of the names come first, each with its part of the element.
                if let StmtKind::Let { value: Some(value), .. } = &mut stmt.kind
                    && let ExprKind::Load(element) = &mut value.kind
                    && element.root == place.root
                    && element.steps.len() > place.steps.len()
                    && element.steps.starts_with(&place.steps)
                    && element.span == place.span
                {
                    copied = true;
                    element.root = copy;
                    element.steps.drain(..place.steps.len());
                }
            }
            if !copied {
                // Its names are references, `for x in table.row_mut(i)`.
                continue;
            }
            let value = Some(place.load().at(span));
            let kind = StmtKind::Let { local: copy, value };
            copies.push(Stmt { kind, span, comments: Vec::new() });
        }
        copies
    }
}

/// The elements that an iterator goes through, if it does nothing else.
pub(super) fn elements_through(iterator: &tree::Closure) -> Option<&tree::Part> {
    let tree::ExprKind::Each { index: None, parts, order: Order::Up, cuts, .. } =
        &iterator.body.kind
    else {
        return None;
    };
    let [part @ tree::Part { array, reversed: false, .. }] = parts.as_slice() else { return None };
    let of_elements = !matches!(array.kind, tree::ExprKind::Call(..)) && cuts.is_empty();
    of_elements.then_some(part)
}

/// The items of a loop: elements, or so many of them at a time.
struct Passed {
    slice: Slice,
    /// How, and how many elements.
    group: Option<(Grouping, Expr)>,
    /// How many passes that makes.
    count: Expr,
    /// The sequence that it goes through then.
    behind: Vec<Slice>,
}

impl Passed {
    fn of(slice: Slice, group: Option<(Grouping, Expr)>) -> Passed {
        let (length, span) = (slice.length.clone(), slice.base.span);
        let Some((mut way, size)) = group else {
            return Passed { slice, group: None, count: length, behind: Vec::new() };
        };
        let size = size.at(span);
        let word = |number: &Expr| match number.kind {
            ExprKind::Literal(word) => Some(word),
            _ => None,
        };
        let known = (word(&length), word(&size));
        if let (Grouping::All, (Some(length), Some(size))) = (way, known)
            && length % size == 0
        {
            way = Grouping::Whole;
        }
        let count = match (way, known) {
            // As many as the other sequence has.
            (Grouping::Around, _) => length,
            (Grouping::Whole, (Some(length), Some(size))) => Expr::usize(length / size, span),
            (Grouping::All | Grouping::First, (Some(length), Some(size))) => {
                Expr::usize(length.div_ceil(size), span)
            }
            (Grouping::Windows, (Some(length), Some(size))) => {
                Expr::usize((length + 1).saturating_sub(size), span)
            }
            (Grouping::Whole, _) => divided(length, size.clone()),
            // No slice is that long, and the sum below would overflow.
            (Grouping::All | Grouping::First, (_, Some(size))) if size > 1 << 31 => {
                lesser(length, Expr::usize(1, span))
            }
            (Grouping::All | Grouping::First, (_, Some(word))) => {
                divided(plus(length, Expr::usize(word - 1, span)), size.clone())
            }
            // The sum might overflow.
            (Grouping::All | Grouping::First, _) => {
                let rest = Expr::binary(BinaryOp::Rem, length.clone(), size.clone());
                plus(divided(length, size.clone()), lesser(rest, Expr::usize(1, span)))
            }
            // One begins at each element but the last `size - 1`.
            (Grouping::Windows, _) => {
                let last = minus(size.clone(), Expr::usize(1, span));
                minus(greatest(length, last.clone()), last)
            }
        };
        let group = Some((way, size));
        Passed { slice, group, count, behind: Vec::new() }
    }

    /// How many passes that makes at most, if the type of the elements' home says so.
    fn most(&self) -> Option<u64> {
        let of = |ty: &Type| match *ty {
            Type::Array { len, .. } => Some(u64::from(len)),
            _ => None,
        };
        match (&self.count.kind, &*self.behind) {
            (ExprKind::Literal(count), _) => Some(*count),
            (_, []) => of(&self.slice.base.ty),
            _ => None,
        }
    }

    /// The continuation.
    fn and(self, behind: Vec<Slice>) -> Passed {
        let count = behind.iter().fold(self.count, |count, it| plus(count, it.length.clone()));
        Passed { count, behind, ..self }
    }
}

/// `index < length`.
fn is_below(index: &Expr, length: &Expr) -> Expr {
    Expr::compare(CompareOp::Lt, index.clone(), length.clone())
}

/// How many passes all of these make. What begins anew has as many elements as what it stands beside.
fn shortest(all: &[Passed], span: Span) -> Expr {
    let all: Vec<_> =
        all.iter().filter(|it| !matches!(it.group, Some((Grouping::Around, _)))).collect();
    let numbers = all.iter().filter_map(|passed| match passed.count.kind {
        ExprKind::Literal(count) => Some(count),
        _ => None,
    });
    let least = numbers.min().map(|least| Expr::usize(least, span));
    let others = all.iter().filter(|passed| !matches!(passed.count.kind, ExprKind::Literal(_)));
    let counts = least.into_iter().chain(others.map(|passed| passed.count.clone()));
    counts.reduce(|end, count| lesser(count, end)).unwrap_or_else(|| Expr::usize(0, span))
}
