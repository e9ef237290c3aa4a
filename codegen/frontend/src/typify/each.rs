//! Lowers `for` over elements of arrays and matrices to a `for` over their indices.
//!
//! A name with a reference type is an alias of the element; a name with a value type is a local.

use bessemer_ir::tree::{self, ExprKind as Tree, Grouping, Pattern, Site, Source, Ty};
use bessemer_ir::{Block, CompareOp, Expr, Place, StmtKind, Type};

use super::frames::Frame;
use super::lengths::{least, minus, number, plus};
use super::lowering::Lowering;
use super::seq::{Item, Kind, Seq, begin, ended_range};
use super::value::{Slice, Value};
use super::words;
use super::{Result, refusals, refused};

/// A `for` loop.
#[derive(Clone, Copy)]
pub(super) struct Each<'e> {
    pub site: Site,
    pub label: Option<&'e str>,
    pub pattern: &'e Pattern,
    pub source: &'e Source,
    /// Bound that the author gives for the number of passes over an own iterator.
    pub bound: Option<&'e tree::Expr>,
    pub body: &'e tree::Block,
}

impl Lowering<'_, '_> {
    pub(super) fn each_stmt(&mut self, each: Each) -> Result<()> {
        let Each { site, label, pattern, source, bound, body } = each;
        let span = self.span(site);
        if self.each_of_own(each)? {
            return Ok(());
        }
        if let Some(bound) = bound {
            // An error of the loop itself comes before one of its bound.
            self.each_stmt(Each { bound: None, ..each })?;
            return refused(bound.site, refusals::SHOWN_BOUND);
        }
        if let Some(source) = &self.meant(source) {
            return self.each_stmt(Each { source, ..each });
        }
        if let Source::Numbers(range) = source {
            return self.for_stmt((range, false), each);
        }
        if let Some(range) = ended_range(source) {
            return self.for_stmt(range, each);
        }
        if self.each_beside(each)? {
            return Ok(());
        }
        if let Some(generated) = self.generated(source)? {
            return self.generated_stmt(generated, each);
        }
        if let Source::Elements(array, _) = source {
            if let Some(matrix) = self.bounded_place(array) {
                return self.each_of_bounded(matrix, each);
            }
            if self.may_be_there(array) {
                return self.one_pass(array, each);
            }
        }
        let seq = match (counted(source), pattern) {
            (true, Pattern::Name { name, .. }) if !name.starts_with('_') => {
                self.naming_as(name, |inner| inner.seq(source, site))?
            }
            _ => self.seq(source, site)?,
        };
        let [from, end] = match (&seq.kind, &seq.to) {
            (Kind::Elements(it), _) if seq.all => [it.slice.from.clone(), it.slice.to.clone()],
            (Kind::Steps(steps), _) if seq.all => steps.ends(),
            (_, Some(to)) => [seq.from.clone(), to.clone()],
            (_, None) => return refused(site, refusals::ENDLESS),
        };
        let mark = self.out.len();
        let mut copies = Vec::new();
        self.repeated(label, None, span, |inner| {
            let variable = inner.local(words::PASS, from.ty.clone(), span);
            let counter = Expr::local(variable, &from.ty, span);
            let mut items = Vec::new();
            match seq.bare() {
                Some(_) => {
                    items.push(Item { pattern, of: Some(&seq.kind), index: counter.clone() })
                }
                None => seq.items(pattern, counter.clone(), (&mut items, site))?,
            }
            let turns = inner.turns(&seq, &items, body)?;
            let over = turns.over;
            if !matches!(items[..], [Item { of: Some(Kind::Steps(_)), .. }]) {
                inner.locals[variable.index()].name = inner.next_index(&items).into();
            }
            inner.counters.push(variable);
            let mut body = inner.scoped(|inner| {
                inner.number_pass((turns, &items), &counter, site)?;
                for item in &items {
                    inner.name_item(item, site)?;
                }
                inner.statements(body)
            })?;
            copies = inner.own_elements(&items, &mut body, span);
            inner.counters.pop();
            Ok(StmtKind::for_way(variable, [from, end], (over, seq.down), body))
        })?;
        self.out.splice(mark..mark, copies);
        Ok(())
    }

    /// Returns a name for the counter of a loop without an index of the author's.
    fn next_index(&self, items: &[Item]) -> &'static str {
        let names = words::COUNTERS;
        let named = |wanted: &str| {
            let is = |it: &Item| {
                let named = matches!(it.pattern, Pattern::Name { name, .. } if name == wanted);
                named && matches!(it.of, None | Some(Kind::Numbers(_) | Kind::Steps(_)))
            };
            items.iter().any(is)
        };
        if let Some(name) = names.iter().find(|it| !named(it)).filter(|it| **it != names[0]) {
            return name;
        }
        let taken =
            self.counters.iter().filter(|id| names.contains(&&*self.locals[id.index()].name));
        names[taken.count() % names.len()]
    }

    /// Binds the pattern of an item.
    fn name_item(&mut self, Item { pattern, of, index }: &Item, site: Site) -> Result<()> {
        let element = match of {
            Some(Kind::Elements(elements)) => elements.slice.at(index.clone()),
            Some(Kind::Value(value)) => value.clone(),
            Some(Kind::Groups(slice, way, size)) => {
                return self.name_group(pattern, slice, (*way, size), index.clone(), site);
            }
            Some(Kind::Chain(parts)) => self.one_of_several(pattern, parts, index.clone(), site)?,
            _ => return Ok(()),
        };
        self.bind_pattern(pattern, &Value::Place(element), site)
    }

    fn name_group(
        &mut self,
        pattern: &Pattern,
        slice: &Slice,
        (way, size): (Grouping, &Expr),
        index: Expr,
        site: Site,
    ) -> Result<()> {
        let begin = match way {
            Grouping::Windows => index,
            _ => begin(index, size),
        };
        let size = size.clone();
        let name = match pattern {
            Pattern::Any => return Ok(()),
            // They are not one behind the other.
            Pattern::Name { .. } if slice.within.is_some() => {
                return refused(site, refusals::MOVED_VIEW);
            }
            Pattern::Name { name, inner: None, .. } => name,
            _ => return refused(site, refusals::WINDOW_APART),
        };
        let length = slice.length.clone();
        let group = match way {
            Grouping::All if number(&length).is_some() => {
                let end = self.atom("end", least(plus(begin.clone(), size), length));
                slice.between(begin, end)
            }
            Grouping::All => {
                let left = least(size, minus(length, begin.clone()));
                let length = self.atom("length", left);
                slice.part(begin, length)
            }
            _ => slice.part(begin, size),
        };
        self.bind(name, Value::Slice(Box::new(group)));
        Ok(())
    }

    /// Copies the element at an index of a `chain` of sequences into a local.
    fn one_of_several(
        &mut self,
        pattern: &Pattern,
        parts: &[Seq],
        mut index: Expr,
        site: Site,
    ) -> Result<Place> {
        let span = index.span;
        let mut cases = Vec::new();
        for part in parts {
            let count = part.ended(site)?;
            let mut items = Vec::new();
            part.items_within(&Pattern::Any, index.clone(), (&mut items, site))?;
            let [Item { of: Some(Kind::Elements(elements)), index: at, .. }] = &items[..] else {
                return refused(site, refusals::CHAINED);
            };
            // What goes through a copy of its own would see what is written.
            if elements.owned && self.denoted(&elements.slice.base, false).is_none() {
                return refused(site, refusals::CHAINED);
            }
            let condition = Expr::compare(CompareOp::Lt, index.clone(), count.clone());
            cases.push((condition, elements.slice.at(at.clone())));
            index = minus(index, count);
        }
        let ty = cases[0].1.ty.clone();
        let name = match pattern {
            Pattern::Name { name, .. } => name.as_str(),
            _ => words::ELEMENT,
        };
        let local = self.local(name, ty.clone(), span);
        self.locals.note_temporary(local);
        let place = Place::local(local, ty, span);
        self.emit(StmtKind::Let { local, value: None }, span);
        let assigned = cases.into_iter().map(|(condition, element)| {
            let assign = StmtKind::Assign { place: place.clone(), value: element.load() };
            (condition, Block::of(assign, span))
        });
        let chosen = assigned.rev().reduce(|(last, otherwise), (condition, then)| {
            (last, Block::of(StmtKind::If { condition, then, otherwise }, span))
        });
        self.out.extend(chosen.into_iter().flat_map(|(_, chosen)| chosen.0));
        Ok(place)
    }

    /// Returns true if the loop iterates over an `Option`.
    pub(super) fn may_be_there(&mut self, of: &tree::Expr) -> bool {
        match (self.seen_as(of), &of.kind) {
            (Some(Ty::Option(_)), _) => true,
            (Some(Ty::Ref(inner, _)), _) => matches!(**inner, Ty::Option(_)),
            (None, Tree::Local(_) | Tree::Field(..) | Tree::Ref(..)) => match self.place_type(of) {
                Ok(Type::Struct(id)) => self.going_on(id) == Some("Some"),
                _ => false,
            },
            _ => false,
        }
    }

    /// Lowers `for x in option` to a test with the body in it. A `break` or a `continue` leaves the test.
    fn one_pass(&mut self, option: &tree::Expr, each: Each) -> Result<()> {
        let of = |kind| tree::Expr::plain(kind, each.site);
        let pattern = Pattern::Constructor("Some".into(), vec![each.pattern.clone()]);
        let there = of(Tree::Let(Box::new(pattern), Box::new(option.clone())));
        let then = of(Tree::If(Box::new(there), each.body.clone(), None));
        let then = tree::Block { stmts: vec![tree::Stmt::Expr(then)], tail: None };
        let frame = Frame { pass: true, ..Frame::of(each.label, None) };
        let span = self.span(each.site);
        self.left(words::PASS, frame, span, |inner| inner.block(&then, None))
    }
}

/// Returns true if a source is a range with a step.
fn counted(source: &Source) -> bool {
    match source {
        Source::Rev(of) => counted(of),
        Source::StepBy(of, _) => matches!(**of, Source::Numbers(_)),
        _ => false,
    }
}
