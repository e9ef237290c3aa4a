//! `for` over the elements of arrays and matrices: a `for` over their indices.
//!
//! A name for a reference is another name for the element; a name for a value is a local of its own.

use bessemer_ir::tree::{self, ExprKind as Tree, Order, Pattern, Site, Ty};
use bessemer_ir::{Block, Expr, ExprKind, Span, Stmt, StmtKind, Type};

use super::lengths::{is_number, least, minus, plus};
use super::lowering::{Frame, Lowering};
use super::numbered::Numbered;
use super::seq::{Seq, shortest};
use super::value::Value;
use super::words;
use super::{Result, problem};
use bessemer_ir::effects;

/// A loop, but for what it goes through.
#[derive(Clone, Copy)]
pub(super) struct Each<'e> {
    pub site: Site,
    pub label: Option<&'e str>,
    pub index: Option<&'e str>,
    pub order: Order,
    pub cuts: &'e [tree::Cut],
    pub body: &'e tree::Block,
}

impl Lowering<'_, '_> {
    pub(super) fn each_stmt(&mut self, parts: &[tree::Part], each: Each) -> Result<()> {
        let Each { site, label, index, order, cuts, body } = each;
        let span = self.span(site);
        if let Some(generated) = self.generated(parts)? {
            return self.generated_stmt(generated, each);
        }
        if let ([part], None, Order::Up, []) = (parts, index, order, cuts) {
            if let Some(matrix) = self.bounded_place(&part.array) {
                return self.each_of_bounded((part, matrix), each);
            }
            if part.group.is_none() && self.may_be_there(&part.array) {
                return self.one_pass(part, each);
            }
        }
        let (mut seqs, mut numbers) = (Vec::new(), Vec::new());
        for part in parts {
            match self.numbers(part, seqs.len())? {
                Some(found) => numbers.push(found),
                None => {
                    let mut seq = self.seq(part, site)?;
                    seq.slice = self.kept_elements(seq.slice);
                    seqs.push(seq);
                }
            }
        }
        if let Some(around) = seqs.iter().find(|it| it.is_around())
            // Then both end with the other sequence, and neither is empty where the other is not.
            && !seqs.iter().any(|it| !it.is_around() && it.is_as_long(around))
        {
            return problem(
                around.part.array.site,
                "`.cycle()` stands beside a loop through the same elements in the DSL",
                "index instead: `values[i % values.len()]`",
            );
        }
        // The counter is the index of the array itself, where nothing else is asked of it.
        let bare =
            index.is_none() && numbers.is_empty() && order != Order::Mirrored && cuts.is_empty();
        let bare = matches!(seqs.as_slice(), [seq] if bare && seq.is_plain());
        let all = shortest(&seqs, span);
        // A mirrored loop counts up and reads its elements from the last one of the whole sequence, also where a cut
        // leaves out some of them.
        let last = minus(all.clone(), Expr::usize(1, span));
        let (from, end) = match bare {
            true => (seqs[0].slice.from.clone(), seqs[0].slice.to.clone()),
            false => self.cut_off((Expr::usize(0, span), all), cuts)?,
        };
        let counts = seqs.iter().map(|it| it.count.clone()).collect();
        let most = seqs.iter().filter_map(Seq::most).min();
        let numbered = self.numbered(numbers, (counts, most), (cuts, body))?;
        let mark = self.out.len();
        let mut copies = Vec::new();
        self.repeated(label, None, span, |inner| {
            let name = index.unwrap_or_else(|| inner.next_index(&numbered));
            let variable = inner.local(name, Type::USIZE, span);
            inner.counters.push(variable);
            let mut body = inner.scoped(|inner| {
                if let Some(index) = index {
                    inner.bind(index, Value::Local(variable));
                }
                let counter = Expr::local(variable, &Type::USIZE, span);
                let counter = match order {
                    Order::Mirrored => minus(last, counter),
                    _ => counter,
                };
                inner.number_pass(&numbered, &counter, site)?;
                for seq in &seqs {
                    inner.name_item(seq, counter.clone(), bare, site)?;
                }
                inner.statements(body)
            })?;
            copies = inner.copy_written(&seqs, &mut body, span);
            inner.counters.pop();
            let way = (numbered.over, order == Order::Down);
            Ok(StmtKind::for_way(variable, [from, end], way, body))
        })?;
        self.out.splice(mark..mark, copies);
        Ok(())
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

    /// The ends of the way, after `.skip(n)` and `.take(n)`.
    fn cut_off(
        &mut self,
        (mut from, mut to): (Expr, Expr),
        cuts: &[tree::Cut],
    ) -> Result<(Expr, Expr)> {
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

    /// A loop over a value does not see what its body writes: then it goes through a copy. Gives the
    /// declarations of the copies.
    fn copy_written(&mut self, seqs: &[Seq], body: &mut Block, span: Span) -> Vec<Stmt> {
        let mut copies = Vec::new();
        for Seq { part, slice, .. } in seqs {
            let place = &slice.base;
            // Elements that are references, whatever they are gone through by: those of a slice with a name.
            let refers = |slot| matches!(self.source.slots.get(slot as usize), Some(Ty::Ref(..)));
            let refers = matches!(part.pattern, Pattern::Name { slot, .. } if refers(slot));
            if !part.owned || refers || !effects::writes_local(body, place.root) {
                continue;
            }
            let local = self.local(words::ELEMENTS, place.ty.clone(), span);
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
                    element.root = local;
                    element.steps.drain(..place.steps.len());
                }
            }
            // Else its names are references, `for x in table.row_mut(i)`.
            if copied {
                let value = Some(place.load().at(span));
                copies.push(Stmt::new(StmtKind::Let { local, value }, span));
            }
        }
        copies
    }

    /// True if the loop goes through an `Option`.
    fn may_be_there(&mut self, of: &tree::Expr) -> bool {
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

    /// `for x in option`: the body, if there is something. What leaves the loop, or the pass, leaves that.
    fn one_pass(&mut self, part: &tree::Part, each: Each) -> Result<()> {
        let of = |kind| tree::Expr::plain(kind, each.site);
        let pattern = Pattern::Constructor("Some".into(), vec![part.pattern.clone()]);
        let there = of(Tree::Let(Box::new(pattern), Box::new(part.array.clone())));
        let then = of(Tree::If(Box::new(there), each.body.clone(), None));
        let then = tree::Block { stmts: vec![tree::Stmt::Expr(then)], tail: None };
        let frame = Frame { pass: true, ..Frame::of(each.label, None) };
        let span = self.span(each.site);
        self.left(words::PASS, frame, span, |inner| inner.block(&then, None))
    }
}
