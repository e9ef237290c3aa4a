//! What a loop over elements goes through: a sequence has a length, and an item at each index.
//!
//! Must not know: how a loop is made of several of them ([`each`](super::each)).

use std::rc::Rc;

use bessemer_ir::tree::{self, ExprKind as Tree, Grouping, Order, Pattern, Site};
use bessemer_ir::{
    BinaryOp, Block, CompareOp, Expr, Fault, Intrinsic, LocalId, Place, Span, StmtKind, Type,
};

use super::lengths::{divided, greatest, least, lesser, minus, number, plus, same, times};
use super::lowering::Lowering;
use super::value::{Slice, Value};
use super::words;
use super::{Result, problem};
use bessemer_ir::effects;

/// The items of a loop: elements, or so many of them at a time.
pub(super) struct Seq<'t> {
    pub part: &'t tree::Part,
    pub slice: Slice,
    /// How, and how many elements.
    group: Option<(Grouping, Expr)>,
    /// How many items there are.
    pub count: Expr,
    /// The slices that it goes through then.
    behind: Vec<Slice>,
    /// The variable that it is, or is a field of: a local, and the fields on the way.
    variable: Option<(LocalId, Vec<String>)>,
}

impl Lowering<'_, '_> {
    /// The sequence of a part.
    pub(super) fn seq<'t>(&mut self, part: &'t tree::Part, site: Site) -> Result<Seq<'t>> {
        let Some(named) = self.iterator_named(&part.array) else {
            return self.seq_of(part, &part.array, part.group.as_ref());
        };
        let named = Rc::clone(&self.closures[named]);
        let own = elements_through(&named.text).unwrap_or(part);
        self.in_scope_of(&named, None, site, |inner| {
            inner.seq_of(part, &own.array, own.group.as_ref())
        })
    }

    fn seq_of<'t>(
        &mut self,
        part: &'t tree::Part,
        array: &tree::Expr,
        group: Option<&tree::Group>,
    ) -> Result<Seq<'t>> {
        let mut behind = self.chained(array)?;
        let slice = behind.remove(0);
        let group = group.map(|group| self.group(group, &slice)).transpose()?;
        let count = behind
            .iter()
            .fold(items(&slice, group.as_ref()), |count, it| plus(count, it.length.clone()));
        Ok(Seq { part, slice, group, count, behind, variable: self.variable(array) })
    }

    fn variable(&self, array: &tree::Expr) -> Option<(LocalId, Vec<String>)> {
        match &array.kind {
            Tree::Local(name) => match self.lookup(name, array.site).ok()? {
                Value::Local(root) => Some((root, Vec::new())),
                Value::Place(place) if place.steps.is_empty() => Some((place.root, Vec::new())),
                _ => None,
            },
            Tree::Field(base, name) => {
                let (root, mut fields) = self.variable(base)?;
                fields.push(name.clone());
                Some((root, fields))
            }
            _ => None,
        }
    }

    /// The slices of a sequence, one after the other; there is at least one.
    fn chained(&mut self, array: &tree::Expr) -> Result<Vec<Slice>> {
        if let Tree::Chain(one, other) = &array.kind {
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

    /// All elements of what a loop goes through.
    fn elements_of(&mut self, expr: &tree::Expr) -> Result<Slice> {
        let mut place = self.base(expr)?;
        // Whether there is a pass or not.
        self.fix(&mut place);
        let bounded = self.contained(&place.ty).is_some();
        let own = matches!(place.ty, Type::Struct(_));
        match self.all_of(place) {
            Some(slice) => Ok(slice),
            None if bounded => problem(
                expr.site,
                "all elements of a `BoundedMatrix` are gone through by themselves, and from the first on",
                "give the matrix a name; or write `for column in 0..m.ncols()`, and index",
            ),
            None if own => problem(
                expr.site,
                "by the names `iter` and `iter_mut` the DSL means those of arrays and vectors",
                "give the method of this type another name: `fn items(&self) -> impl Iterator<Item = &T>`",
            ),
            None => problem(
                expr.site,
                "a loop goes through arrays and vectors in the DSL",
                "write `for i in 0..n`, and index",
            ),
        }
    }

    /// How many elements an item has: a literal, or a local that is not zero.
    fn group(&mut self, group: &tree::Group, slice: &Slice) -> Result<(Grouping, Expr)> {
        let (size, site) = (self.value(&group.size, Some(&Type::USIZE))?, group.size.site);
        let size = match (group.way, self.known(&size)) {
            (Grouping::Around, first) if first.is_none_or(|it| it > u64::from(u32::MAX)) => {
                return problem(
                    site,
                    "the number of the first element is known when the C is written, in the DSL",
                    "write a number: `values.iter().cycle().skip(1)`",
                );
            }
            (Grouping::Around, _) => size,
            (_, Some(0)) => {
                return problem(
                    site,
                    "no elements at a time never come to an end",
                    "write a number above 0",
                );
            }
            (_, Some(word)) => Expr::usize(word, size.span),
            (_, None) => {
                let span = size.span;
                let size = self.steady("size", size);
                let some = Expr::compare(CompareOp::Ne, size.clone(), Expr::usize(0, span));
                self.check(some, Fault::Assertion, span);
                size
            }
        };
        let way = match (group.way, number(&slice.length), number(&size)) {
            (Grouping::All, Some(length), Some(size)) if length % size == 0 => Grouping::Whole,
            (way, ..) => way,
        };
        Ok((way, size.at(slice.base.span)))
    }

    /// Names the item at an index; `bare`: of the array itself.
    pub(super) fn name_item(
        &mut self,
        seq: &Seq,
        index: Expr,
        bare: bool,
        site: Site,
    ) -> Result<()> {
        let element = match &seq.group {
            _ if !seq.behind.is_empty() => {
                let last = minus(seq.count.clone(), Expr::usize(1, index.span));
                let index = if seq.part.reversed { minus(last, index) } else { index };
                self.one_of_several(seq, index)
            }
            Some((way @ (Grouping::Windows | Grouping::Whole | Grouping::All), size)) => {
                let index = match seq.part.reversed {
                    true => minus(minus(seq.count.clone(), Expr::usize(1, index.span)), index),
                    false => index,
                };
                return self.name_group(seq, (*way, size.clone()), index, site);
            }
            _ => seq.element(index, bare),
        };
        self.bind_pattern(&seq.part.pattern, &Value::Place(element), site)
    }

    fn name_group(
        &mut self,
        Seq { part, slice, .. }: &Seq,
        (way, size): (Grouping, Expr),
        index: Expr,
        site: Site,
    ) -> Result<()> {
        let begin = match way {
            Grouping::Windows => index,
            _ => begin(index, &size),
        };
        let name = match &part.pattern {
            Pattern::Any => return Ok(()),
            // They are not one behind the other.
            Pattern::Name { .. } if slice.within.is_some() => return Self::moved_part(site),
            Pattern::Name { name, inner: None, .. } => name,
            _ => {
                return problem(
                    site,
                    "a window is not taken apart in the DSL",
                    "give it a name, and index it",
                );
            }
        };
        let length = slice.length.clone();
        let group = match way {
            Grouping::All if number(&length).is_some() => {
                let end = self.steady("end", least(plus(begin.clone(), size), length));
                slice.between(begin, end)
            }
            Grouping::All => {
                let left = least(size, minus(length, begin.clone()));
                let length = self.steady("length", left);
                slice.part(begin, length)
            }
            _ => slice.part(begin, size),
        };
        self.bind(name, Value::Slice(Box::new(group)));
        Ok(())
    }

    /// The element at an index of several slices, in a local of its own.
    fn one_of_several(&mut self, seq: &Seq, mut index: Expr) -> Place {
        let (ty, span) = (seq.slice.element.clone(), index.span);
        let name = match &seq.part.pattern {
            Pattern::Name { name, .. } => name.as_str(),
            _ => words::ELEMENT,
        };
        let local = self.local(name, ty.clone(), span);
        self.held.insert(local);
        let place = Place::local(local, ty, span);
        self.emit(StmtKind::Let { local, value: None }, span);
        let mut cases = Vec::new();
        for slice in std::iter::once(&seq.slice).chain(&seq.behind) {
            let value = slice.at(plus(slice.from.clone(), index.clone())).load();
            let assign = StmtKind::Assign { place: place.clone(), value };
            let condition = Expr::compare(CompareOp::Lt, index.clone(), slice.length.clone());
            cases.push((condition, Block::of(assign, span)));
            index = minus(index, slice.length.clone());
        }
        let chosen = cases.into_iter().rev().reduce(|(last, otherwise), (condition, then)| {
            (last, Block::of(StmtKind::If { condition, then, otherwise }, span))
        });
        self.out.extend(chosen.into_iter().flat_map(|(_, chosen)| chosen.0));
        place
    }
}

impl Seq<'_> {
    /// Whether a counter can be the index of the array itself.
    pub(super) fn is_plain(&self) -> bool {
        self.group.is_none() && self.behind.is_empty()
    }

    /// Whether it begins anew behind its last element.
    pub(super) fn is_around(&self) -> bool {
        matches!(self.group, Some((Grouping::Around, _)))
    }

    /// Whether another sequence has as many elements.
    pub(super) fn is_as_long(&self, other: &Seq) -> bool {
        let (one, two) = (&self.slice, &other.slice);
        let is_same_slice = effects::same_place(&one.base, &two.base)
            && same(&one.from, &two.from)
            && same(&one.to, &two.to);
        let is_same_variable = self.variable.is_some() && self.variable == other.variable;
        same(&self.count, &other.count) || is_same_slice || is_same_variable
    }

    /// How many items there are at most, if the type of the elements' home says so.
    pub(super) fn most(&self) -> Option<u64> {
        match (number(&self.count), &self.slice.base.ty) {
            (Some(count), _) => Some(count),
            (None, Type::Array { len, .. }) if self.behind.is_empty() => Some(u64::from(*len)),
            _ => None,
        }
    }

    /// The element at an index.
    fn element(&self, index: Expr, bare: bool) -> Place {
        let slice = &self.slice;
        let index = match &self.group {
            Some((Grouping::Around, first)) => {
                let at = plus(index, first.clone());
                Expr::binary(BinaryOp::Rem, at, slice.length.clone())
            }
            Some((_, size)) => begin(index, size),
            None => index,
        };
        slice.at(match self.part.reversed && !self.is_around() {
            false if bare => index,
            false => plus(slice.from.clone(), index),
            true => minus(minus(slice.to.clone(), Expr::usize(1, slice.base.span)), index),
        })
    }
}

/// Where a group begins.
fn begin(index: Expr, size: &Expr) -> Expr {
    match size.is_literal() {
        true => times(index, size.clone()),
        // Each begins within the sequence.
        false => Expr::intrinsic(Intrinsic::WrappingMul, vec![index, size.clone()]),
    }
}

/// How many items the elements of a slice make.
fn items(slice: &Slice, group: Option<&(Grouping, Expr)>) -> Expr {
    let length = slice.length.clone();
    let Some((way, size)) = group.filter(|(way, _)| *way != Grouping::Around) else {
        return length;
    };
    let (one, size) = (Expr::usize(1, slice.base.span), size.clone());
    let known = number(&length);
    // What is a number in the end stands where the slice does.
    let length = match known.and(number(&size)) {
        Some(_) => length.at(slice.base.span),
        None => length,
    };
    match (way, number(&size)) {
        (Grouping::Whole, _) => divided(length, size),
        // One begins at each element but the last `size - 1`.
        (Grouping::Windows, _) => {
            let last = minus(size, one);
            minus(greatest(length, last.clone()), last)
        }
        // No slice is that long, and the sum below would overflow.
        (_, Some(size)) if known.is_none() && size > 1 << 31 => lesser(length, one),
        (_, Some(_)) => divided(plus(length, minus(size.clone(), one)), size),
        // The sum might overflow.
        (_, None) => {
            let rest = Expr::binary(BinaryOp::Rem, length.clone(), size.clone());
            plus(divided(length, size), lesser(rest, one))
        }
    }
}

/// How many passes all of these make. What begins anew has as many elements as what it stands beside.
pub(super) fn shortest(all: &[Seq], span: Span) -> Expr {
    let counts = || all.iter().filter(|it| !it.is_around()).map(|it| &it.count);
    let least = counts().filter_map(number).min().map(|least| Expr::usize(least, span));
    let others = counts().filter(|count| number(count).is_none()).cloned();
    let counts = least.into_iter().chain(others);
    counts.reduce(|end, count| lesser(count, end)).unwrap_or_else(|| Expr::usize(0, span))
}

/// The elements that an iterator goes through, if it does nothing else.
pub(super) fn elements_through(iterator: &tree::Closure) -> Option<&tree::Part> {
    let Tree::Each { index: None, parts, order: Order::Up, cuts, .. } = &iterator.body.kind else {
        return None;
    };
    let [part @ tree::Part { array, reversed: false, .. }] = parts.as_slice() else { return None };
    let of_elements = !matches!(array.kind, Tree::Call(..)) && cuts.is_empty();
    of_elements.then_some(part)
}
