//! Ranges that a loop iterates over beside other sequences: `(0..).zip(&values)`, `values.iter().zip(1..)`.
//!
//! core queries the parts of a `zip` one after the other. An open range that is queried after the last number of its
//! type overflows, which is a fault. If no pass can reach that number, the item is the counter plus the first number.
//! Else each pass queries the parts in core's order, and an additional pass begins if a range precedes the part that
//! ends the loop.
//!
//! Must not know: the type of the elements.

use bessemer_ir::tree::{self, EACH, ExprKind as Tree, Pattern, Site};
use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, Fault, Int, Intrinsic, LocalId, Place, Span, StmtKind, Type,
};

use super::expr::{Operand, two};
use super::lengths::{is_number, lesser, plus};
use super::lowering::Lowering;
use super::seq::{Item, Kind, Seq};
use super::stepped::Numbers;
use super::value::Value;
use super::{Needed, Result, refusals, refused, words};

/// Order in which a pass queries its parallel sequences.
pub(super) struct Turns {
    /// Number of passes of the other sequences: before the first range that may overflow, between two such ranges,
    /// and after the last.
    counts: Vec<Vec<Expr>>,
    /// True if an additional pass begins, in which a range is queried once more.
    pub over: bool,
}

impl Lowering<'_, '_> {
    /// Lowers a range to a sequence, with a step if it has one.
    pub(super) fn numbers(
        &mut self,
        (range, down): (&tree::Range, bool),
        step: Option<&tree::Expr>,
    ) -> Result<Seq> {
        let site = range.from.site;
        let (ty, span) = (self.type_of_numbers(range, site)?, self.span(site));
        let int = counting(&ty, site)?;
        if range.to.is_some() {
            let steps = self.steps((range, down), step, (int, &ty))?;
            let count = Some(steps.count());
            return Ok(Seq::new(Kind::Steps(steps), count, span));
        }
        let first = self.value(&range.from, Some(&ty))?;
        let first = match self.known(&first) {
            Some(word) => Expr::literal(word, ty, span),
            None => self.atom(words::BOUNDS[0], first),
        };
        let kind = Kind::Numbers(Numbers { site, first, int, calm: false });
        Ok(Seq::new(kind, None, span))
    }

    /// Returns the order of queries for a loop over these items.
    pub(super) fn turns(&self, seq: &Seq, items: &[Item], body: &tree::Block) -> Result<Turns> {
        let (mut sides, mut counts, mut loud) = (Vec::new(), vec![Vec::new()], Vec::new());
        seq.sides(&mut sides);
        for side in sides {
            match &side.kind {
                Kind::Numbers(numbers)
                    if !numbers.calm && (side.whole() || std::ptr::eq(side, seq)) =>
                {
                    loud.push(numbers);
                    counts.push(Vec::new());
                }
                _ => counts.last_mut().into_iter().for_each(|it| it.extend(side.length())),
            }
        }
        let over = counts[1..].iter().any(|it| !it.is_empty());
        // What elements come before is asked once for each, whoever goes through them.
        let elsewhere = over && (hands_on(body) || !seq.all);
        let skips = !seq.all && !is_number(&seq.from, 0);
        let is_told =
            |it: &Numbers| elsewhere || skips || !loud.iter().any(|side| std::ptr::eq(*side, it));
        let mut all = items.iter().filter_map(|item| match item.of {
            Some(Kind::Numbers(it)) if !it.calm => Some(it),
            _ => None,
        });
        match all.find(|it| is_told(it)) {
            Some(numbers) => refused(numbers.site, refusals::LAST_NUMBER),
            None => Ok(Turns { counts, over }),
        }
    }

    /// Emits the numbers of a pass, in the order of the sequences.
    pub(super) fn number_pass(
        &mut self,
        (turns, items): (Turns, &[Item]),
        counter: &Expr,
        site: Site,
    ) -> Result<()> {
        let mut counts = turns.counts.into_iter().map(|it| it.into_iter().filter(|_| turns.over));
        for item in items {
            if matches!(item.of, Some(Kind::Numbers(numbers)) if !numbers.calm) {
                self.end_pass(counter, counts.next().into_iter().flatten());
            }
            self.one_number(item, counter, site)?;
        }
        self.end_pass(counter, counts.next().into_iter().flatten());
        Ok(())
    }

    /// Leaves the additional pass when a sequence of known length has ended.
    fn end_pass(&mut self, counter: &Expr, counts: impl Iterator<Item = Expr>) {
        let Some(count) = counts.reduce(|one, other| lesser(other, one)) else { return };
        let span = counter.span;
        let there = Expr::compare(CompareOp::Lt, counter.clone(), count);
        self.emit_if(there.negated(), Block::of(StmtKind::Break, span), span);
    }

    /// Emits the number of a pass, if the item is one.
    fn one_number(&mut self, item: &Item, counter: &Expr, site: Site) -> Result<()> {
        let Item { pattern, of, index } = item;
        let (value, loud) = match of {
            None => (index.clone(), None),
            Some(Kind::Steps(steps)) => (steps.number(index.clone()), None),
            Some(Kind::Numbers(it)) if it.calm => {
                (plus(index.clone().cast(&it.first.ty), it.first.clone()), None)
            }
            Some(Kind::Numbers(it)) => {
                let index = index.clone().cast(&it.first.ty);
                let both = vec![it.first.clone(), index];
                (Expr::intrinsic(Intrinsic::WrappingAdd, both), Some(it))
            }
            _ => return Ok(()),
        };
        match (pattern, &counter.kind) {
            (Pattern::Any, _) if loud.is_none() => return Ok(()),
            (Pattern::Name { name, inner: None, .. }, ExprKind::Load(place))
                if loud.is_none() && value.ty == counter.ty && value.kind == counter.kind =>
            {
                self.locals[place.root.index()].name.clone_from(name);
                self.bind(name, Value::Local(place.root));
                return self.own_number(pattern, site);
            }
            _ => {}
        }
        if let (Some(Kind::Steps(_)), Pattern::Name { name, inner: None, .. }) = (of, pattern) {
            self.let_named(name, value, index.span);
            return self.own_number(pattern, site);
        }
        let place = self.local_number(pattern, value.at(index.span));
        if let Some(Numbers { first, int, site, .. }) = loud {
            let last = Expr::literal_like(Int::max(*int) as u64, first);
            let condition = Expr::compare(CompareOp::Ne, place.load(), last);
            let span = self.span(*site);
            self.emit(StmtKind::Check { condition, fault: Fault::Overflow }, span);
        }
        self.bind_pattern(pattern, &Value::Place(place), site)
    }

    /// Copies the number of a pass that its author assigns.
    pub(super) fn own_number(&mut self, pattern: &Pattern, site: Site) -> Result<()> {
        let Pattern::Name { name, slot, mutable: true, .. } = pattern else { return Ok(()) };
        let value = Some(tree::Expr::local(name, site));
        let own = tree::Stmt::Let { name: name.clone(), slot: *slot, value, site, mutable: true };
        self.stmts(&tree::Block { stmts: vec![own], tail: None })
    }

    /// Declares a local with the author's name for the number of a pass.
    fn local_number(&mut self, pattern: &Pattern, value: Expr) -> Place {
        let name = match pattern {
            Pattern::Name { name, .. } => name,
            _ => words::NEXT,
        };
        let place = self.let_local(name, value);
        self.locals.note_temporary(place.root);
        place
    }

    /// Returns the bounds of a `for` over a range. The upper bound of an open range is the last number of its type;
    /// it is queried, but never passed to the body.
    pub(super) fn ends(&mut self, range: &tree::Range, ty: &Type, site: Site) -> Result<[Expr; 2]> {
        let expected = Some(ty.clone());
        if let Some(to) = &range.to {
            let ends = self.operands(&[
                Operand { expr: &range.from, expected: expected.clone(), role: "start" },
                Operand { expr: to, expected, role: "end" },
            ])?;
            return two(ends, site);
        }
        let last = counting(ty, site)?.max();
        let last = Expr::literal(last as u64, ty.clone(), self.span(site));
        Ok([self.value(&range.from, Some(ty))?, last])
    }

    /// Emits the check with which a pass over an open range begins: its last number has no successor.
    pub(super) fn ask_open(&mut self, variable: LocalId, last: &Expr, span: Span) {
        let next = Expr::local(variable, &last.ty, span);
        let condition = Expr::compare(CompareOp::Ne, next, last.clone());
        self.emit(StmtKind::Check { condition, fault: Fault::Overflow }, span);
    }
}

/// Returns the integer type of a loop counter.
fn counting(ty: &Type, site: Site) -> Result<Int> {
    ty.as_int().or_refused(site, refusals::COUNTER)
}

/// Returns true if a body yields its item, so that another loop's body consumes it.
pub(super) fn hands_on(body: &tree::Block) -> bool {
    let last = body.stmts.last();
    matches!(last, Some(tree::Stmt::Expr(tree::Expr { kind: Tree::Apply(name, _), .. })) if name == EACH)
}
