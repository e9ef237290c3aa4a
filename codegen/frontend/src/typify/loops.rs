//! Lowers loops, and `break` and `continue`.
//!
//! A loop with a declared bound is a `for` over its passes; one with a proved bound is a `for` that its own condition
//! ends. Leaving a loop that is not the innermost sets a flag: each loop in between ends, and the flag is tested
//! after it.

use bessemer_ir::tree::{self, Builtin, ListMethod, Pattern, Site};
use bessemer_ir::visit::Walk;
use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, Fault, Int, LocalId, LogicOp, Mode, Place, Scalar, Span,
    Step, Stmt, StmtKind, Type,
};

use crate::fuse;
use crate::termination::{self, Loop, Proof};

use super::each::Each;
use super::frames::{Behind, Frame, Leaving, Target};
use super::lengths::size;
use super::locals::Locals;
use super::lowering::Lowering;
use super::order::is_light;
use super::single_pass::single_pass;
use super::syntax::{is_named, some_of};
use super::value::Named;
use super::words;
use super::{Needed, Result, problem, refusals, refused};

/// Remedy for a loop without a proved bound.
pub(super) const DECLARE: &str = "write `#[bound(64)]` above the loop, which makes any further pass a fault; or count: `while i < n { …; i += 1; }`";

impl Lowering<'_, '_> {
    /// Lowers a `for` over a range, reversed or not.
    pub(super) fn for_stmt(
        &mut self,
        (range, reversed): (&tree::Range, bool),
        Each { site, label, pattern, body, .. }: Each,
    ) -> Result<()> {
        let (ty, span) = (self.type_of_numbers(range, site)?, self.span(site));
        let ends = self.ends(range, &ty, site)?;
        let name = match pattern {
            Pattern::Name { name, .. } if !name.starts_with('_') => name,
            _ => words::PASS,
        };
        self.repeated(label, None, span, |inner| {
            let mut variable = LocalId(0);
            let body = inner.scoped(|inner| {
                variable = inner.declare(name, ty.clone(), Mode::Value, span);
                inner.locals.note_counter(variable);
                if range.to.is_none() {
                    inner.ask_open(variable, &ends[1], span);
                }
                inner.own_number(pattern, site)?;
                inner.statements(body)
            })?;
            let inclusive = range.inclusive || range.to.is_none();
            Ok(StmtKind::for_way(variable, ends, (inclusive, reversed), body))
        })
    }

    /// Lowers `while` and `loop`. A condition is tested once more than the bound allows passes. The value of a
    /// `loop`'s `break` is assigned to `target` if there is one.
    pub(super) fn while_stmt(
        &mut self,
        site: Site,
        label: Option<&str>,
        (condition, bound): (Option<&tree::Expr>, Option<&tree::Expr>),
        body: &tree::Block,
        target: Option<&Target>,
    ) -> Result<()> {
        if let (Some(condition), None) = (condition, bound)
            && let Some((pattern, rest)) = self.rest_of(condition, body)
        {
            let (source, bound) = (&rest, None);
            return self.each_stmt(Each { site, label, pattern, source, bound, body });
        }
        if let (Some(condition), None) = (condition, bound)
            && let Some((source, body)) = self.as_many_as_left(condition, body)
        {
            let (source, pattern, body) = (&source, &Pattern::Any, &body);
            return self.each_stmt(Each { site, label, pattern, source, bound, body });
        }
        let span = self.span(site);
        let bound = bound.map(|bound| self.passes(bound)).transpose()?;
        let popped = condition.map(|it| self.popped_length(it)).transpose()?.flatten();
        let (mut endless, mut behind) = (false, Vec::new());
        self.repeated(label, target, span, |inner| {
            let declared =
                bound.map(|bound| (inner.local(words::PASS, bound.ty.clone(), span), bound));
            let mut heads = Vec::new();
            let mut body = inner.scoped(|inner| {
                let mut names = Vec::new();
                if let Some(condition) = condition {
                    heads = inner.heads(condition, &mut names, span)?;
                }
                if let Some((pass, bound)) = &declared {
                    let pass = Expr::local(*pass, &bound.ty, span);
                    let begins = Expr::compare(CompareOp::Lt, pass, bound.clone());
                    inner.check(begins, Fault::Bound, span);
                }
                inner.bind_names(&names)?;
                inner.statements(body)
            })?;
            let Some((pass, bound)) = declared else {
                let shown = match popped {
                    _ if condition.is_none() => {
                        // What leaves an outer loop is looked at right behind this one.
                        if inner.frames.ends_at_once() {
                            behind = last_breath(&inner.locals, &mut body);
                        }
                        return inner.ended_loop(site, body);
                    }
                    Some(length) => {
                        let name = |place: &Place| inner.place_name(place);
                        let rest = &inner.fused(&body).0[heads[0] + 1..];
                        termination::popped(&inner.cx.module, name, &length, rest)
                    }
                    None => inner.shown(&body, &heads),
                };
                return inner.ended(site, shown, body);
            };
            endless = !body.0.iter().any(breaks_in);
            if endless {
                body.0.remove(0);
            }
            // Another pass than the bound says begins, for its check to tell.
            let bounds = [Expr::literal_like(0, &bound), bound];
            Ok(StmtKind::for_way(pass, bounds, (!endless, false), body))
        })?;
        self.out.extend(behind);
        if endless {
            // Behind the last pass there is nothing but the fault.
            self.check(Expr::bool(false, span), Fault::Bound, span);
        }
        Ok(())
    }

    /// Returns the length of the list from which `while let Some(…) = list.pop()` removes elements.
    fn popped_length(&mut self, condition: &tree::Expr) -> Result<Option<Expr>> {
        if let Some((_, value)) = some_of(condition)
            && let Some((Builtin::List(ListMethod::Pop), [list])) = self.builtin_call(value)
            && is_named(list, false)
        {
            let list = self.base(list)?;
            return Ok(self.list_items(&list).map(|(length, _)| length.load()));
        }
        Ok(None)
    }

    /// Emits the tests that leave a loop if its condition is false, and returns the indices of these `if`s.
    /// Conditions that C can compute in one expression share an `if`. Statements that a condition needs run only if
    /// the conditions before it hold.
    fn heads(
        &mut self,
        condition: &tree::Expr,
        names: &mut Vec<Named>,
        span: Span,
    ) -> Result<Vec<usize>> {
        let leave = |condition: Expr| {
            let then = Block::of(StmtKind::Break, span);
            Stmt::new(StmtKind::if_then(condition.negated(), then), span)
        };
        let is_true = |condition: &Expr| condition.kind == ExprKind::Literal(1);
        let (mut holds, mut heads) = (Expr::bool(true, span), Vec::new());
        for part in conjuncts(condition) {
            let (next, stmts) = self.in_block(|inner| inner.further_condition(part, names))?;
            let (next, stmts) = self.joined(next, stmts, names);
            holds = match stmts.is_empty() {
                _ if is_true(&holds) => next,
                true if is_true(&next) => holds,
                true => Expr::logic(LogicOp::And, holds, next),
                false => {
                    heads.push(self.out.len());
                    self.out.push(leave(holds));
                    next
                }
            };
            self.out.extend(stmts);
        }
        // What always holds leaves nowhere.
        if heads.is_empty() || !is_true(&holds) {
            heads.push(self.out.len());
            self.out.push(leave(holds));
        }
        Ok(heads)
    }

    /// Returns the body of a loop with its temporaries substituted.
    fn fused(&self, body: &Block) -> Block {
        fuse::view(&self.cx.module, &self.locals, &|local| self.locals.is_atom(local), body)
    }

    /// Returns the bound of a loop that one of the `if`s at `heads` ends.
    fn shown(&self, body: &Block, heads: &[usize]) -> Result<Proof, termination::Reason> {
        let name = |place: &Place| self.place_name(place);
        let body = self.fused(body);
        let shown = |head: &usize| {
            let of = left_at(&body.0, *head, &self.out).ok_or_else(no_end)?;
            termination::proof(&self.cx.module, name, &of)
        };
        let mut all = heads.iter().map(shown);
        let first = all.next().unwrap_or_else(|| Err(no_end()));
        first.or_else(|why| all.find_map(Result::ok).ok_or(why))
    }

    /// Lowers a `loop` without a declared bound. One of its `if … { break; }` must prove that it ends.
    fn ended_loop(&mut self, site: Site, body: Block) -> Result<StmtKind> {
        if self.frames.ends_at_once() && single_pass(&body.0).is_some() {
            let zero = Expr::usize(0, self.span(site));
            let proof = Proof { low: zero.clone(), high: zero, inclusive: false };
            return self.ended(site, Ok(proof), body);
        }
        let mut shown = Err(no_end());
        let view = self.fused(&body);
        let first = view.0.iter().position(|stmt| !matches!(stmt.kind, StmtKind::Expr(_)));
        for head in 0..view.0.len() {
            let Some(of) = left_at(&view.0, head, &self.out) else { continue };
            let name = |place: &Place| self.place_name(place);
            match termination::proof(&self.cx.module, name, &of) {
                Ok(proof) => return self.ended(site, Ok(proof), body),
                Err(reason) => match termination::turned(&self.cx.module, name, &of) {
                    // Nothing is known of its first pass, but that it ends: any number of passes is enough.
                    Ok(()) => {
                        let (span, ty) = (self.span(site), Type::Scalar(Scalar::Int(Int::U64)));
                        let [low, high] =
                            [0, u64::MAX].map(|word| Expr::literal(word, ty.clone(), span));
                        return self.ended(site, Ok(Proof { low, high, inclusive: false }), body);
                    }
                    Err(turned) => shown = Err(if first == Some(head) { reason } else { turned }),
                },
            }
        }
        self.ended(site, shown, body)
    }

    /// Returns the loop statement for a body that ends within a proved bound.
    fn ended(
        &mut self,
        site: Site,
        shown: Result<Proof, termination::Reason>,
        body: Block,
    ) -> Result<StmtKind> {
        let span = self.span(site);
        let Proof { low, high, inclusive } = match shown {
            Ok(proof) => proof,
            Err(reason) => {
                return problem(site, format!("this loop has no known bound: {reason}"), DECLARE);
            }
        };
        // The last pass comes no further than the condition, so there is one more than the proof says.
        let int = low.ty.as_int().needed(site, "no integers")?;
        let limit = |value: i128| Expr::literal_like(value as u64, &low);
        let from = if is_light(&low) { low.clone() } else { limit(int.min()) };
        let to = if is_light(&high) && !inclusive { high } else { limit(int.max()) };
        let variable = self.local(words::PASS, from.ty.clone(), span);
        let (inclusive, reversed, unroll, ended) = (true, false, None, true);
        Ok(StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body })
    }

    /// Returns a place as the author would write it.
    fn place_name(&self, place: &Place) -> String {
        let mut name = self.locals[place.root.index()].name.replace('%', "");
        let mut ty = &self.locals[place.root.index()].ty;
        for step in &place.steps {
            if let (Step::Field(field), Type::Struct(id)) = (step, ty) {
                let field = &self.cx.module.structs[id.index()].fields[*field as usize];
                name = format!("{name}.{}", field.name);
                ty = &field.ty;
            }
        }
        name
    }

    /// Lowers the declared bound of a loop.
    fn passes(&mut self, bound: &tree::Expr) -> Result<Expr> {
        let value = self.value(bound, Some(&Type::USIZE))?;
        if value.ty.as_int().is_none() {
            return refused(bound.site, refusals::BOUND);
        }
        Ok(value)
    }

    pub(super) fn statements(&mut self, body: &tree::Block) -> Result<()> {
        self.stmts(body)?;
        match &body.tail {
            Some(tail) => self.effect(tail),
            None => Ok(()),
        }
    }

    /// Lowers a loop and emits it, followed by tests of the flags that its body sets.
    pub(super) fn repeated(
        &mut self,
        label: Option<&str>,
        target: Option<&Target>,
        span: Span,
        lower: impl FnOnce(&mut Self) -> Result<StmtKind>,
    ) -> Result<()> {
        self.frames.enter(Frame::of(label, target));
        let kind = lower(self);
        let behind = self.frames.end();
        let kind = kind?;
        for Behind { flag, left, .. } in &behind {
            // That of a block is declared where the block begins.
            if self.frames.declares_flag(*left) {
                let value = Expr::bool(false, span);
                self.emit(StmtKind::Let { local: *flag, value: Some(value) }, span);
            }
        }
        match self.at_most_once(&kind, span).filter(|_| behind.is_empty()) {
            Some(pass) => self.out.extend(pass.0),
            None => self.emit(kind, span),
        }
        for Behind { flag, left, leaving } in behind {
            // What this loop stands in ends as well, unless it is the one that goes on.
            let kind = self.frames.way_out(left, leaving).unwrap_or(StmtKind::Break);
            self.emit_if(Expr::local(flag, &Type::BOOL, span), Block::of(kind, span), span);
        }
        Ok(())
    }

    /// Emits a loop over the numbers below `end`, with a counter named `name`.
    pub(super) fn below(
        &mut self,
        name: &str,
        end: Expr,
        span: Span,
        body: impl FnOnce(&mut Self, Expr) -> Result<()>,
    ) -> Result<()> {
        self.repeated(None, None, span, |inner| {
            let variable = inner.local(name, Type::USIZE, span);
            inner.counters.push(variable);
            let at = Expr::local(variable, &Type::USIZE, span);
            let body = inner.scoped(|inner| body(inner, at));
            inner.counters.pop();
            Ok(StmtKind::for_below(variable, end, body?))
        })
    }

    /// Emits loops over the rows of each column of a matrix. A single row or column has no loop.
    pub(super) fn each_cell(
        &mut self,
        name: &str,
        (rows, cols): (u32, u32),
        span: Span,
        body: impl FnOnce(&mut Self, Expr, Expr) -> Result<()>,
    ) -> Result<()> {
        self.below_unless_one(name, cols, span, |walk, column| {
            walk.below_unless_one(words::ROW, rows, span, |walk, row| body(walk, row, column))
        })
    }

    /// Emits a loop over the numbers below `count`, unless that is 1.
    pub(super) fn below_unless_one(
        &mut self,
        name: &str,
        count: u32,
        span: Span,
        body: impl FnOnce(&mut Self, Expr) -> Result<()>,
    ) -> Result<()> {
        match count {
            1 => body(self, Expr::usize(0, span)),
            _ => self.below(name, size(count, span), span, body),
        }
    }

    /// Lowers the body of a loop that is several nested loops in the C. `outermost` is the first of their frames.
    pub(super) fn pass_of<T>(
        &mut self,
        label: Option<&str>,
        outermost: usize,
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        self.frames.enter(Frame { outermost: Some(outermost), ..Frame::of(label, None) });
        let done = lower(self);
        self.frames.end();
        done
    }

    /// Lowers `break`, with its value if it has one.
    pub(super) fn break_stmt(
        &mut self,
        label: Option<&str>,
        value: Option<&tree::Expr>,
        site: Site,
    ) -> Result<()> {
        if let Some(value) = value {
            let target = self.frames.target(label, site)?;
            self.lowered(value, target.as_ref())?;
            if matches!(target, Some(Target::Return)) {
                return Ok(());
            }
        }
        self.leave(label, Leaving::Break, site)
    }

    /// Returns the target of the value with which `return` or `?` leaves: the labelled closure body, or else the
    /// function.
    pub(super) fn left_by(&self, label: Option<&str>, site: Site) -> Result<Target> {
        match label {
            Some(_) => self
                .frames
                .target(label, site)?
                .needed(site, "this exit has a value, but its target has none"),
            None => Ok(Target::Return),
        }
    }

    /// Emits the statements that leave a pass of the loop with this label, or of the innermost.
    pub(super) fn leave(
        &mut self,
        label: Option<&str>,
        leaving: Leaving,
        site: Site,
    ) -> Result<()> {
        let span = self.span(site);
        let (left, named) = self.frames.left(label, leaving, site)?;
        if let Some(kind) = self.frames.way_out(left, leaving) {
            self.emit(kind, span);
            return Ok(());
        }
        let flag = self.frames.flag(left, leaving).unwrap_or_else(|| {
            let label = named.unwrap_or_else(|| words::LOOP.into());
            let role = match leaving {
                Leaving::Break => words::DONE,
                Leaving::Continue => words::NEXT,
            };
            self.local(format!("{label}_{role}"), Type::BOOL, span)
        });
        self.frames.test_behind(left, flag, leaving);
        let place = Place::local(flag, Type::BOOL, span);
        let value = Expr::bool(true, span);
        self.emit(StmtKind::Assign { place, value }, span);
        self.emit(StmtKind::Break, span);
        Ok(())
    }
}

/// Returns the loop that the `if … { break; }` at index `head` of its body leaves.
fn left_at<'a>(body: &'a [Stmt], head: usize, lead: &'a [Stmt]) -> Option<Loop<'a>> {
    let StmtKind::If { condition, then, otherwise } = &body.get(head)?.kind else { return None };
    let leaves = matches!(then.0.last()?.kind, StmtKind::Break | StmtKind::Return(_));
    (leaves && otherwise.0.is_empty()).then(|| Loop {
        before: &body[..head],
        condition,
        truth: false,
        rest: &body[head + 1..],
        lead,
    })
}

fn no_end() -> termination::Reason {
    "its body has no `if … { break; }` of its own".into()
}

/// Returns the statements before the only `break`, with which a loop body begins, and removes them. They run after
/// the loop.
fn last_breath(locals: &Locals, body: &mut Block) -> Vec<Stmt> {
    let is_held = |stmt: &&Stmt| fuse::may_go(stmt, &|local| locals.is_atom(local));
    let count = body.0.iter().take_while(is_held).count();
    let (held, body) = body.0.split_at_mut(count);
    let Some((head, rest)) = body.split_first_mut() else { return Vec::new() };
    let StmtKind::If { then, .. } = &mut head.kind else { return Vec::new() };
    let declares = |place: &Place| {
        held.iter().any(|it| matches!(it.kind, StmtKind::Let { local, .. } if local == place.root))
    };
    if rest.iter().any(breaks_in) || then.any_place(|place, _| declares(place)) {
        return Vec::new();
    }
    match then.0.last() {
        Some(Stmt { kind: StmtKind::Break, .. }) => then.0.drain(..then.0.len() - 1).collect(),
        Some(Stmt { kind: StmtKind::Return(_), span, .. }) => {
            let only = Block::of(StmtKind::Break, *span);
            std::mem::replace(then, only).0
        }
        _ => Vec::new(),
    }
}

/// Returns the operands of nested `&&`, in order.
fn conjuncts(condition: &tree::Expr) -> Vec<&tree::Expr> {
    match &condition.kind {
        tree::ExprKind::Binary(tree::BinaryOp::LogicAnd, left, right) => {
            [conjuncts(left), conjuncts(right)].concat()
        }
        _ => vec![condition],
    }
}

/// Returns true if a statement of a loop's body ends the loop.
fn breaks_in(stmt: &Stmt) -> bool {
    stmt.any_branch(&|kind| matches!(kind, StmtKind::Break))
}
