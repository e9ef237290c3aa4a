//! Numbers from one on beside elements: `(0..).zip(&values)`, `values.iter().zip(1..)`.
//!
//! core asks the parts of a `zip` one after the other, and a range that is asked for its last number steps beyond it, which
//! is a fault. Where no pass comes so far, a number is the counter and the first number; else each pass asks in core's
//! order, and one more begins where a range stands before what ends the loop.
//!
//! Must not know: what the elements are.

use bessemer_ir::tree::{self, EACH, ExprKind as Tree, NO_SLOT, Site};
use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, Fault, Int, Intrinsic, LocalId, Place, Span, StmtKind, Type,
};

use super::expr::{Operand, two};
use super::lengths::{lesser, plus};
use super::lowering::Lowering;
use super::value::Value;
use super::{Needed, Result, problem, words};

/// The numbers that stand beside elements.
pub(super) struct Numbers<'t> {
    pattern: &'t tree::Pattern,
    site: Site,
    first: Expr,
    int: Int,
    /// How many parts with elements stand before them.
    before: usize,
    /// Whether no pass comes to the last number of their type.
    calm: bool,
}

/// What a loop with such numbers looks like.
pub(super) struct Numbered<'t> {
    all: Vec<Numbers<'t>>,
    /// How many passes each part with elements makes.
    counts: Vec<Expr>,
    /// Whether another pass begins than elements make, for a range to be asked once more.
    pub over: bool,
}

impl Numbered<'_> {
    /// Whether numbers have a name.
    pub(super) fn named(&self, wanted: &str) -> bool {
        let is =
            |it: &Numbers| matches!(it.pattern, tree::Pattern::Name { name, .. } if name == wanted);
        self.all.iter().any(is)
    }
}

impl Lowering<'_, '_> {
    /// The numbers of a part, if that is what it has.
    pub(super) fn numbers<'t>(
        &mut self,
        part: &'t tree::Part,
        before: usize,
    ) -> Result<Option<Numbers<'t>>> {
        let Tree::From(first) = &part.array.kind else { return Ok(None) };
        let (pattern, site) = (&part.pattern, part.array.site);
        let ty = self.slot(part.array.slot.unwrap_or(NO_SLOT), site)?;
        let int = counting(&ty, site)?;
        let first = self.value(first, Some(&ty))?;
        let first = match self.known(&first) {
            Some(word) => Expr::literal(word, ty, self.span(site)),
            None => self.steady(words::BOUNDS[0], first),
        };
        Ok(Some(Numbers { pattern, site, first, int, before, calm: false }))
    }

    /// How a loop through parts with elements and numbers goes, by how many passes each part makes, and how many at most.
    pub(super) fn numbered<'t>(
        &mut self,
        mut all: Vec<Numbers<'t>>,
        (counts, most): (Vec<Expr>, Option<u64>),
        (cuts, body): (&[tree::Cut], &tree::Block),
    ) -> Result<Numbered<'t>> {
        for numbers in &mut all {
            let ExprKind::Literal(word) = numbers.first.kind else { continue };
            // No slice is longer than half of all that has an address.
            let most = i128::from(most.unwrap_or(1 << 63));
            numbers.calm = numbers.int.from_word(word) + most < numbers.int.max();
        }
        let over = all.iter().any(|it| !it.calm && it.before < counts.len());
        // What elements come before is asked once for each, whoever goes through them.
        let elsewhere = over && (hands_on(body) || !cuts.is_empty());
        let skips = cuts.iter().any(|cut| cut.skip);
        if let Some(loud) = all.iter().find(|it| !it.calm && (elsewhere || skips)) {
            return problem(
                loud.site,
                "these numbers may come to the last of their type, and how many are asked for does not show here",
                "let the elements come first, `values.iter().zip(first..)`, without `.skip(n)`; or number with `0_usize..`",
            );
        }
        Ok(Numbered { all, counts, over })
    }

    /// Gives a pass its numbers, asked in the order in which the parts stand.
    pub(super) fn number_pass(&mut self, of: &Numbered, counter: &Expr, site: Site) -> Result<()> {
        let mut ended = 0;
        for numbers in &of.all {
            if !numbers.calm {
                self.end_pass(of, ended..numbers.before, counter);
                ended = numbers.before;
            }
            self.one_number(numbers, counter, site)?;
        }
        self.end_pass(of, ended..of.counts.len(), counter);
        Ok(())
    }

    /// Leaves the pass that is over where one of these parts has come to its end.
    fn end_pass(&mut self, of: &Numbered, parts: std::ops::Range<usize>, counter: &Expr) {
        let count = of.counts[parts].iter().cloned().reduce(|one, other| lesser(other, one));
        let Some(count) = count.filter(|_| of.over) else { return };
        let span = counter.span;
        let there = Expr::compare(CompareOp::Lt, counter.clone(), count);
        self.emit_if(there.negated(), Block::of(StmtKind::Break, span), span);
    }

    fn one_number(&mut self, numbers: &Numbers, counter: &Expr, site: Site) -> Result<()> {
        let (first, span) = (numbers.first.clone(), counter.span);
        let is_unread = matches!(numbers.pattern, tree::Pattern::Any);
        let itself = first.ty == Type::USIZE && first.kind == ExprKind::Literal(0);
        let place = match &counter.kind {
            _ if numbers.calm && is_unread => return Ok(()),
            ExprKind::Load(counter) if numbers.calm && itself => {
                if let tree::Pattern::Name { name, .. } = numbers.pattern {
                    self.locals[counter.root.index()].name.clone_from(name);
                    self.bind(name, Value::Local(counter.root));
                    return Ok(());
                }
                counter.clone()
            }
            _ => {
                let counter = counter.clone().cast(&first.ty);
                let value = match numbers.calm {
                    true => plus(counter, first.clone()),
                    false => Expr::intrinsic(Intrinsic::WrappingAdd, vec![first.clone(), counter]),
                };
                self.local_number(numbers.pattern, value.at(span))
            }
        };
        if !numbers.calm {
            let last = Expr::literal_like(numbers.int.max() as u64, &first);
            let condition = Expr::compare(CompareOp::Ne, place.load(), last);
            let span = self.span(numbers.site);
            self.emit(StmtKind::Check { condition, fault: Fault::Overflow }, span);
        }
        self.bind_pattern(numbers.pattern, &Value::Place(place), site)
    }

    /// The number of a pass, in a local of its author's name.
    fn local_number(&mut self, pattern: &tree::Pattern, value: Expr) -> Place {
        let name = match pattern {
            tree::Pattern::Name { name, .. } => name,
            _ => words::NEXT,
        };
        let place = self.let_local(name, value);
        self.held.insert(place.root);
        place
    }

    /// The ends of the range of a `for`; of one that has none, the last number of its type, which it is only asked for.
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

    /// Begins a pass through a range without an end: from its last number there is no step.
    pub(super) fn ask_open(&mut self, variable: LocalId, last: &Expr, span: Span) {
        let next = Expr::local(variable, &last.ty, span);
        let condition = Expr::compare(CompareOp::Ne, next, last.clone());
        self.emit(StmtKind::Check { condition, fault: Fault::Overflow }, span);
    }
}

/// The integers that a loop counts in.
fn counting(ty: &Type, site: Site) -> Result<Int> {
    ty.as_int().or_told(site, "a loop counts in integers in the DSL", "number with `0..`")
}

/// Whether a pass hands on what it goes through: then who asks for it is another.
fn hands_on(body: &tree::Block) -> bool {
    let last = body.stmts.last();
    matches!(last, Some(tree::Stmt::Expr(tree::Expr { kind: Tree::Apply(name, _), .. })) if name == EACH)
}
