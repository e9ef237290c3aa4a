//! Sequences, over which loops iterate: each has a length, and an item at each index.
//!
//! Invariant: whatever Rust copies when it creates the iterator (an end, a size, a number of skipped items) is
//! evaluated there, in Rust's order. Everything else is arithmetic on an index.
//!
//! Must not know: how a loop over a sequence is built ([`each`](super::each)).

use std::rc::Rc;

use bessemer_ir::tree::{self, ExprKind as Tree, Grouping, Pattern, Site, Source};
use bessemer_ir::{BinaryOp, CompareOp, Expr, Fault, Intrinsic, Place, Span, Type};

use super::by_hand::takes;
use super::lengths::{divided, greatest, least, lesser, minus, number, plus, same, times};
use super::lowering::{Closure, Lowering};
use super::pattern::aligned;
use super::stepped::{Numbers, Steps};
use super::value::Slice;
use super::{Needed, Result, refusals, refused, words};

/// A sequence: items at the indices from `from` to `to`, in this order or reversed.
pub(super) struct Seq {
    pub kind: Kind,
    /// Total number of items; none if endless.
    count: Option<Expr>,
    /// First index, and the index after the last; none if endless.
    pub from: Expr,
    pub to: Option<Expr>,
    pub down: bool,
    /// True if neither `skip` nor `take` removed items.
    pub all: bool,
    /// Line of the author, for the expressions that are built.
    pub span: Span,
}

pub(super) enum Kind {
    Elements(Elements),
    /// The value of an `Option` or a `Result`, if there is one.
    Value(Place),
    /// Numbers of a range without an end.
    Numbers(Numbers),
    /// Numbers of a range with an end, perhaps with a step.
    Steps(Steps),
    /// Slices of a constant size: chunks or windows.
    Groups(Slice, Grouping, Expr),
    Zip(Box<Seq>, Box<Seq>),
    /// Sequences one after the other.
    Chain(Vec<Seq>),
    Enumerate(Box<Seq>),
    /// A sequence that repeats without end.
    Cycle(Box<Seq>),
    /// Every `n`th item of a sequence.
    StepBy(Box<Seq>, Expr),
}

/// Elements of an array.
pub(super) struct Elements {
    pub slice: Slice,
    /// True if the loop iterates over a copy.
    pub owned: bool,
}

/// One of the items of a pass; a loop over zipped sequences has one for each.
pub(super) struct Item<'s> {
    pub pattern: &'s Pattern,
    /// The sequence that the item comes from; none if the item is the index, as `enumerate` gives it.
    pub of: Option<&'s Kind>,
    /// Index of the item in `of`; for an element, its index in the array.
    pub index: Expr,
}

impl Lowering<'_, '_> {
    /// Lowers a source to its sequence.
    pub(super) fn seq(&mut self, source: &Source, site: Site) -> Result<Seq> {
        match source {
            Source::Elements(array, owned) => self.elements(array, *owned, site),
            Source::Numbers(range) => self.numbers((range, false), None),
            Source::Groups(way, array, size) => {
                let slice = self.slice_through(array)?;
                let span = slice.base.span;
                let size = self.group_size(size)?.at(span);
                let way = match (way, number(&slice.length), number(&size)) {
                    (Grouping::All, Some(length), Some(size)) if length % size == 0 => {
                        Grouping::Whole
                    }
                    (way, ..) => *way,
                };
                let count = groups(way, &slice.length, &size, span);
                Ok(Seq::new(Kind::Groups(slice, way, size), Some(count), span))
            }
            Source::Zip(one, other, _) => {
                let (mut one, mut other) =
                    (self.inner_seq(one, site)?, self.inner_seq(other, site)?);
                let most = one.most().into_iter().chain(other.most()).min();
                one.calm(most);
                other.calm(most);
                let mut sides = Vec::new();
                one.side(&mut sides);
                other.side(&mut sides);
                let all = sides.iter().filter_map(|it| it.length());
                let (count, span) = (shortest(all.chain(beside(&sides))), one.span);
                Ok(Seq::new(Kind::Zip(Box::new(one), Box::new(other)), count, span))
            }
            Source::Chain(one, other) => {
                let mut parts = Vec::new();
                for source in [one, other] {
                    match self.inner_seq(source, site)? {
                        Seq { kind: Kind::Chain(inner), all: true, down: false, .. } => {
                            parts.extend(inner);
                        }
                        part => parts.push(part),
                    }
                }
                let (counts, span) = (parts.iter().map(Seq::length), parts[0].span);
                let count = counts.reduce(|all, it| Some(plus(all?, it?))).flatten();
                Ok(Seq::new(Kind::Chain(parts), count, span))
            }
            Source::Enumerate(of) => {
                let of = self.inner_seq(of, site)?;
                let (count, span) = (of.length(), of.span);
                Ok(Seq::new(Kind::Enumerate(Box::new(of)), count, span))
            }
            Source::Cycle(of) => {
                let of = self.inner_seq(of, site)?;
                of.ended(site)?;
                let span = of.span;
                Ok(Seq::new(Kind::Cycle(Box::new(of)), None, span))
            }
            Source::StepBy(of, size) => {
                if let Some(range) = ended_range(of) {
                    return self.numbers(range, Some(size));
                }
                let of = self.inner_seq(of, site)?;
                let (length, span) = (of.ended(site)?, of.span);
                let size = self.group_size(size)?.at(span);
                let count = match number(&length).is_some() || of.is_in_memory() {
                    true => groups(Grouping::All, &length, &size, span),
                    // No more than there are items to step through.
                    false => Expr::intrinsic(
                        Intrinsic::WrappingAdd,
                        rounded_up(length, size.clone(), span).into(),
                    ),
                };
                Ok(Seq::new(Kind::StepBy(Box::new(of), size), Some(count), span))
            }
            // The last number of a type has no number of its own.
            Source::Rev(_) if let Some(range) = ended_range(source) => self.numbers(range, None),
            Source::Rev(of) => {
                let of = self.seq(of, site)?;
                of.ended(site)?;
                Ok(Seq { down: !of.down, ..of })
            }
            Source::Skip(of, count) => {
                let of = self.seq(of, site)?;
                self.cut(of, count, true)
            }
            Source::Take(of, count) => {
                let of = self.seq(of, site)?;
                self.cut(of, count, false)
            }
        }
    }

    /// Lowers a source that is an operand of another: its first index is evaluated once, before the loop.
    fn inner_seq(&mut self, source: &Source, site: Site) -> Result<Seq> {
        let seq = self.seq(source, site)?;
        // How many were taken changes from pass to pass.
        let from = self.atom(words::BOUNDS[0], seq.from.clone());
        Ok(Seq { from, ..seq })
    }

    /// Lowers `skip` (`skip` set) and `take`: drops the first `count` items, or all others.
    fn cut(&mut self, mut of: Seq, count: &tree::Expr, skip: bool) -> Result<Seq> {
        let site = count.site;
        let count = self.value(count, Some(&Type::USIZE))?;
        // No more were taken than there are.
        let taken = self.is_taken(&count);
        // An index behind it begins anew.
        if let (true, Kind::Elements(Elements { slice, owned })) = (of.whole() && !taken, &of.kind)
        {
            let count = least(count, slice.length.clone());
            let count = self.atom("count", count);
            let slice = match skip {
                true => slice.behind(count),
                false => slice.part(Expr::usize(0, slice.base.span), count),
            };
            return Ok(Seq::elements(slice, *owned));
        }
        let from = of.from.clone();
        let Some(to) = of.to.take() else {
            // What begins anew goes on, and gives as many as are taken if it has some.
            if !matches!(&of.kind, Kind::Cycle(of) if skip || of.has_some()) {
                return refused(site, refusals::ENDLESS);
            }
            let end = plus(from.clone(), self.atom("count", count));
            return Ok(match skip {
                true => Seq { from: end, all: false, ..of },
                false => Seq { to: Some(end), all: false, ..of },
            });
        };
        let count = match taken {
            true => count,
            false => {
                let count = least(count, minus(to.clone(), from.clone()));
                self.atom("count", count)
            }
        };
        let (from, to) = match (skip, of.down) {
            (true, false) => (plus(from, count), to),
            (false, false) => (from.clone(), plus(from, count)),
            (true, true) => (from, minus(to, count)),
            (false, true) => (minus(to.clone(), count), to),
        };
        Ok(Seq { from, to: Some(to), all: false, ..of })
    }

    /// Returns all elements of an array, or the sequence of a named iterator.
    fn elements(&mut self, array: &tree::Expr, owned: bool, site: Site) -> Result<Seq> {
        if let Some(named) = self.iterator_named(array) {
            let named = Rc::clone(&self.closures[named]);
            if let Some(source) = elements_through(&named) {
                return self.in_scope_of(&named, None, site, |inner| inner.inner_seq(source, site));
            }
        }
        if self.may_be_there(array) {
            return value_there(self, array, owned, site);
        }
        Ok(Seq::elements(self.slice_through(array)?, owned))
    }

    /// Returns all elements of the array over which a loop iterates.
    fn slice_through(&mut self, array: &tree::Expr) -> Result<Slice> {
        let slice = match self.submatrix(array)? {
            Some(part) => part.elements(),
            None => self.all_elements(array, |inner, ty| match ty {
                bounded if inner.contained(bounded).is_some() => refusals::BOUNDED_MATRIX,
                Type::Struct(_) => refusals::OWN_ITER,
                _ => refusals::GONE_THROUGH,
            })?,
        };
        Ok(self.kept_elements(slice))
    }

    /// Returns the size of a group: a literal, or a local that was checked not to be zero.
    fn group_size(&mut self, size: &tree::Expr) -> Result<Expr> {
        let (size, site) = (self.value(size, Some(&Type::USIZE))?, size.site);
        match self.known(&size) {
            Some(0) => refused(site, refusals::EMPTY_GROUPS),
            Some(word) => Ok(Expr::usize(word, size.span)),
            None => {
                let span = size.span;
                let size = self.atom("size", size);
                let some = Expr::compare(CompareOp::Ne, size.clone(), Expr::usize(0, span));
                self.check(some, Fault::Assertion, span);
                Ok(size)
            }
        }
    }
}

impl Seq {
    /// Returns all items of a kind.
    pub(super) fn new(kind: Kind, count: Option<Expr>, span: Span) -> Seq {
        let (from, to) = (Expr::usize(0, span), count.clone());
        Seq { kind, count, from, to, down: false, all: true, span }
    }

    fn elements(slice: Slice, owned: bool) -> Seq {
        let (count, span) = (Some(slice.length.clone()), slice.base.span);
        Seq::new(Kind::Elements(Elements { slice, owned }), count, span)
    }

    /// Returns true if the sequence has all items of its kind, first to last.
    pub(super) fn whole(&self) -> bool {
        self.all && !self.down
    }

    /// Returns the number of items; none if endless.
    pub(super) fn length(&self) -> Option<Expr> {
        Some(minus(self.to.clone()?, self.from.clone()))
    }

    /// The number of items, which `skip`, `rev` and the like need; refused if the sequence has no end.
    pub(super) fn ended(&self, site: Site) -> Result<Expr> {
        self.length().or_refused(site, refusals::ENDLESS)
    }

    /// Returns true if the sequence certainly has items.
    fn has_some(&self) -> bool {
        self.length().as_ref().and_then(number).is_some_and(|count| count > 0)
    }

    /// The sequence that an endless `cycle` repeats.
    fn again(&self) -> Option<&Seq> {
        match &self.kind {
            Kind::Cycle(of) if self.to.is_none() => Some(of),
            _ => None,
        }
    }

    /// Collects the zipped sequences that a sequence consists of, each from its first item on.
    pub(super) fn sides<'s>(&'s self, all: &mut Vec<&'s Seq>) {
        match &self.kind {
            Kind::Zip(one, other) => {
                one.side(all);
                other.side(all);
            }
            Kind::Enumerate(of) => of.side(all),
            _ => all.push(self),
        }
    }

    /// Adds this sequence to those gone through side by side: its own sides if it is whole, itself otherwise.
    fn side<'s>(&'s self, all: &mut Vec<&'s Seq>) {
        match self.whole() {
            true => self.sides(all),
            false => all.push(self),
        }
    }

    /// Returns true if the sequence has at most as many items as an array in memory.
    fn is_in_memory(&self) -> bool {
        match &self.kind {
            _ if !self.whole() => false,
            Kind::Elements(_) => true,
            Kind::Zip(one, other) => one.is_in_memory() || other.is_in_memory(),
            Kind::Enumerate(of) => of.is_in_memory(),
            _ => false,
        }
    }

    /// Returns an upper bound of the number of items, if the array's type has one.
    fn most(&self) -> Option<u64> {
        let length = self.length();
        let known = length.as_ref().and_then(number).or(self.count.as_ref().and_then(number));
        match (known, &self.kind) {
            (Some(count), _) => Some(count),
            (None, Kind::Elements(Elements { slice, .. }) | Kind::Groups(slice, ..)) => {
                match &slice.base.ty {
                    Type::Array { len, .. } => Some(u64::from(*len)),
                    _ => None,
                }
            }
            (None, Kind::Zip(one, other)) => one.most().into_iter().chain(other.most()).min(),
            (None, Kind::Enumerate(of) | Kind::StepBy(of, _)) => of.most(),
            _ => None,
        }
    }

    /// Records that at most `most` items are requested, so that an open range may not overflow.
    fn calm(&mut self, most: Option<u64>) {
        let whole = self.whole();
        match &mut self.kind {
            _ if !whole => {}
            Kind::Numbers(numbers) => numbers.calm(most),
            Kind::Zip(one, other) => [one, other].into_iter().for_each(|it| it.calm(most)),
            Kind::Enumerate(of) => of.calm(most),
            _ => {}
        }
    }

    /// Returns the elements over which the loop iterates one by one, if the counter is the array's own index.
    pub(super) fn bare(&self) -> Option<&Elements> {
        match &self.kind {
            Kind::Elements(elements) if self.all => Some(elements),
            _ => None,
        }
    }

    /// Collects the items of the pass whose index, counted from the first item of the kind, is `index`.
    pub(super) fn items<'s>(
        &'s self,
        pattern: &'s Pattern,
        index: Expr,
        (all, site): (&mut Vec<Item<'s>>, Site),
    ) -> Result<()> {
        let index = match &self.kind {
            Kind::Elements(it) => plus(it.slice.from.clone(), index),
            Kind::Zip(one, other) => {
                let [left, right] = pair(pattern, site)?;
                one.items_within(left, index.clone(), (all, site))?;
                return other.items_within(right, index, (all, site));
            }
            Kind::Enumerate(of) => {
                let [number, pattern] = pair(pattern, site)?;
                all.push(Item { pattern: number, of: None, index: index.clone() });
                return of.items_within(pattern, index, (all, site));
            }
            Kind::Cycle(of) => {
                let index = Expr::binary(BinaryOp::Rem, index, of.ended(site)?);
                return of.items_within(pattern, index, (all, site));
            }
            Kind::StepBy(of, size) => {
                return of.items_within(pattern, begin(index, size), (all, site));
            }
            Kind::Numbers(_)
            | Kind::Steps(_)
            | Kind::Groups(..)
            | Kind::Chain(_)
            | Kind::Value(_) => index,
        };
        all.push(Item { pattern, of: Some(&self.kind), index });
        Ok(())
    }

    /// Collects the items of the pass whose index, counted from the first item of this sequence, is `index`.
    pub(super) fn items_within<'s>(
        &'s self,
        pattern: &'s Pattern,
        index: Expr,
        (all, site): (&mut Vec<Item<'s>>, Site),
    ) -> Result<()> {
        let back = |to: &Expr, index: Expr| {
            let last = minus(to.clone(), Expr::usize(1, to.span));
            minus(last, index)
        };
        match (self.bare(), &self.to) {
            (Some(it), _) if self.down => {
                let index = back(&it.slice.to, index);
                all.push(Item { pattern, of: Some(&self.kind), index });
                Ok(())
            }
            (_, Some(to)) if self.down => self.items(pattern, back(to, index), (all, site)),
            _ => self.items(pattern, plus(self.from.clone(), index), (all, site)),
        }
    }
}

/// Returns the value in an `Option` as a sequence of at most one item.
fn value_there(
    lowering: &mut Lowering,
    option: &tree::Expr,
    owned: bool,
    site: Site,
) -> Result<Seq> {
    let mut place = lowering.base(option)?;
    if owned {
        place = lowering.hold_copy(words::OPTION, place);
    }
    let span = place.span;
    let Type::Struct(id) = place.ty else { return refused(site, refusals::GONE_THROUGH) };
    let name = lowering.going_on(id).or_refused(site, refusals::GONE_THROUGH)?;
    let (word, case) = lowering.case(id, name).or_refused(site, refusals::GONE_THROUGH)?;
    let field = case.field.or_refused(site, refusals::EMPTY_OPTION)?;
    let count = lowering.tag_is(&place, id, word).cast(&Type::USIZE);
    let value = lowering.part(&place, id, field as usize);
    Ok(Seq::new(Kind::Value(value), Some(count), span))
}

/// Returns the two patterns of a pair.
pub(super) fn pair(pattern: &Pattern, site: Site) -> Result<[&Pattern; 2]> {
    if let Pattern::Any = pattern {
        return Ok([pattern; 2]);
    }
    if let Pattern::Tuple(parts) = pattern {
        let part = |index| {
            let aligned = aligned(parts, 2).into_iter();
            aligned.filter(|it| it.1 == index).map(|it| it.0).next().unwrap_or(&Pattern::Any)
        };
        return Ok([part(0), part(1)]);
    }
    refused(site, refusals::PAIRS)
}

/// Returns the index at which a group begins.
pub(super) fn begin(index: Expr, size: &Expr) -> Expr {
    match size.is_literal() {
        true => times(index, size.clone()),
        // Each begins within the sequence.
        false => Expr::intrinsic(Intrinsic::WrappingMul, vec![index, size.clone()]),
    }
}

/// Returns the number of groups in a slice of this length.
fn groups(way: Grouping, length: &Expr, size: &Expr, span: Span) -> Expr {
    let (one, size) = (Expr::usize(1, span), size.clone());
    let known = number(length);
    // What is a number in the end stands where the elements do.
    let length = match known.and(number(&size)) {
        Some(_) => length.clone().at(span),
        None => length.clone(),
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
        (_, None) => {
            let [whole, rest] = rounded_up(length, size, span);
            plus(whole, rest)
        }
    }
}

/// `length / size` rounded up, as two terms to be added: the whole groups, and 1 if there is a rest. No sum overflows.
fn rounded_up(length: Expr, size: Expr, span: Span) -> [Expr; 2] {
    let rest = Expr::binary(BinaryOp::Rem, length.clone(), size.clone());
    [divided(length, size), lesser(rest, Expr::usize(1, span))]
}

/// Returns a range with an end, and true if the loop iterates over it in reverse.
pub(super) fn ended_range(source: &Source) -> Option<(&tree::Range, bool)> {
    match source {
        Source::Numbers(range) => range.to.is_some().then_some((range, false)),
        Source::Rev(of) => match &**of {
            Source::Numbers(range) => Some((range, true)),
            _ => None,
        },
        _ => None,
    }
}

/// Returns the length of the shortest of zipped sequences.
fn shortest(counts: impl Iterator<Item = Expr>) -> Option<Expr> {
    let (known, others): (Vec<_>, Vec<_>) = counts.partition(|count| number(count).is_some());
    let least = known.into_iter().reduce(least);
    least.into_iter().chain(others).reduce(|end, count| lesser(count, end))
}

/// Returns bounds for repeating sequences that may be empty: 0 if one is empty, else a number that limits nothing.
fn beside(sides: &[&Seq]) -> impl Iterator<Item = Expr> {
    let again = sides.iter().filter_map(|it| it.again()).filter(|of| !of.has_some());
    let lengths = again.filter_map(|of| of.length());
    let is_beside =
        |length: &Expr| sides.iter().filter_map(|it| it.length()).any(|it| same(&it, length));
    lengths.filter(move |length| !is_beside(length)).map(|length| {
        let most = Expr::usize(u64::MAX, length.span);
        Expr::intrinsic(Intrinsic::SaturatingMul, vec![length, most])
    })
}

/// Returns the source of a named iterator, if its items are unchanged elements or numbers.
pub(super) fn elements_through<'c>(iterator: &'c Closure<'_>) -> Option<&'c Source> {
    let Tree::Each { pattern, source, .. } = &iterator.text.body.kind else { return None };
    let is_made = |leaf: &&Source| matches!(leaf, Source::Elements(of, _) if matches!(of.kind, Tree::Call(..) | Tree::Apply(..)));
    (!takes(pattern) && !source.leaves().iter().any(is_made)).then_some(&**source)
}
