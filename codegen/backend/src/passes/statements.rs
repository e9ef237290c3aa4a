//! Makes statements explicit, one function at a time.
//!
//! Pre- and postcondition: see [`flatten`](super::flatten). In addition, a value that would be written to a place
//! that it still reads goes through a local. Bounds of a loop that its body changes, or that contain calls, are held
//! before it. A proved check is removed.

use bessemer_ir::visit::Walk;
use bessemer_ir::{
    Arm, Block, Expr, ExprKind, Fault, Function, LocalId, LogicOp, Module, Place, Span, Stmt,
    StmtKind, Type,
};

use super::analysis::{Loop, Results, State};
use super::checked;
use super::flatten::when;
use super::lowering::Lowering;
use super::names::{self, Purpose};
use super::places::{disturbs, erased, moves_itself, weight};
use super::positions::{Callee, Position};
use super::remaining::{Doubted, Remaining};
use crate::late::Early;
use bessemer_ir::effects::{is_own, lent, moves, reads, whole, writes};

/// A function in explicit IR.
pub(super) struct Explicit {
    pub(super) function: Function,
    /// Remaining checks.
    pub(super) remaining: Vec<Remaining>,
    /// Intervals of the numbers in its result.
    pub(super) results: Results,
}

/// Facts about the functions before this one.
#[derive(Clone, Copy)]
pub(super) struct Before<'m> {
    pub(super) callees: &'m [Callee],
    pub(super) results: &'m [Results],
}

/// Makes one function explicit. Enums are normalised if that saves checks.
pub(super) fn function(
    module: &Module,
    before: Before,
    function: &Function,
    doubted: &Doubted,
    keeps: bool,
) -> Explicit {
    let lowered = |brings| lowered(module, before, function.clone(), brings, doubted, keeps);
    let plain = lowered(false);
    if plain.remaining.is_empty() || !reads_enum(function) {
        return plain;
    }
    let brought = lowered(true);
    if brought.remaining.len() < plain.remaining.len() { brought } else { plain }
}

/// Returns true if a function reads an enum.
fn reads_enum(function: &Function) -> bool {
    let reads = |expr: &Expr| {
        matches!(expr.ty, Type::Enum(_)) && !matches!(expr.kind, ExprKind::Literal(_))
    };
    function.body.any_expr(reads)
}

fn lowered(
    module: &Module,
    Before { callees, results }: Before,
    mut function: Function,
    brings: bool,
    doubted: &Doubted,
    keeps: bool,
) -> Explicit {
    let needed = if doubted.is_empty() { Vec::new() } else { checked::needed(module, &function) };
    let body = std::mem::take(&mut function.body);
    let own = function.locals.len();
    let facts = State::with_results(module, results);
    let (out, base, remaining, pending) = (Vec::new(), String::new(), Vec::new(), Vec::new());
    let mut lowering = Lowering {
        module,
        callees,
        function,
        facts,
        out,
        base,
        brings,
        doubted,
        pending,
        needed,
        asked: None,
        keeps,
        remaining,
        returned: None,
    };
    let body = lowering.block(body);
    let Lowering { mut function, remaining, returned, .. } = lowering;
    function.body = body;
    super::declare::late(&mut function);
    super::tidy::tidy(&mut function, own, callees);
    while super::gather::gather(module, &mut function) {
        // Fewer statements are between a value and its use; each local stays, as in explicit code that passes again.
        let own = function.locals.len();
        super::tidy::tidy(&mut function, own, callees);
    }
    // What the firmware brings may return something else.
    let own = function.attributes.external.is_none();
    let results = returned.filter(|_| own).unwrap_or_default();
    Explicit { function, remaining, results }
}

impl Lowering<'_> {
    fn block(&mut self, block: Block) -> Block {
        let outer = std::mem::take(&mut self.out);
        block.0.into_iter().for_each(|stmt| self.stmt(stmt));
        Block(std::mem::replace(&mut self.out, outer))
    }

    fn stmt(&mut self, stmt: Stmt) {
        let Stmt { kind, span, comments } = stmt;
        let start = self.out.len();
        self.base.clear();
        match kind {
            StmtKind::Let { local, value } => self.declaration(local, value, span),
            StmtKind::Assign { place, value } => self.assign(place, value, span),
            StmtKind::Expr(expr) => self.effect(expr, span),
            StmtKind::If { condition, then, otherwise } => {
                self.branch(condition, then, otherwise, span)
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                self.select(scrutinee, arms, otherwise, span);
            }
            StmtKind::For { .. } => self.repeat(kind, span),
            StmtKind::Check { condition, fault } => self.assertion(condition, fault, span),
            StmtKind::Return(Some(value)) => {
                self.base = self.function.result_name.clone();
                let value = self.lower(value, Position::Whole, Purpose::Operand);
                let results = Results::of(self.facts.parts(&value));
                self.returned = Some(match self.returned.take() {
                    Some(before) => before.or(&results),
                    None => results,
                });
                self.emit(StmtKind::Return(Some(value)), span);
            }
            StmtKind::Return(None) | StmtKind::Break | StmtKind::Continue => self.emit(kind, span),
        }
        // A check that is left out goes, and its comments with it.
        let stays =
            |stmt: &Stmt| !matches!(stmt.kind, StmtKind::Check { fault: Fault::LeftOut, .. });
        let first = self.out.iter().skip(start).position(stays).unwrap_or(0);
        if let Some(first) = self.out.get_mut(start + first)
            && !comments.is_empty()
        {
            first.comments = comments;
        }
    }

    fn declaration(&mut self, local: LocalId, value: Option<Expr>, span: Span) {
        self.base = self.function.local(local).name.clone();
        let value = value.map(|value| self.lower(value, Position::Whole, Purpose::Operand));
        let known = value.as_ref().map(|value| self.facts.parts(value)).unwrap_or_default();
        self.facts.forget(&value.as_ref().map(lent).unwrap_or_default());
        self.facts.assign(&whole(local), known);
        value.iter().for_each(|value| self.facts.define(local, value));
        self.emit(StmtKind::Let { local, value }, span);
    }

    fn assign(&mut self, place: Place, value: Expr, span: Span) {
        self.base = names::place(self.module, &self.function, &place);
        let mut value = self.lower(value, Position::Whole, Purpose::Operand);
        let (known, written) = (self.facts.parts(&value), lent(&value));
        self.facts.forget(&written);
        if !self.is_statement(&value) {
            self.protect(&mut value, &lent(&place));
        }
        let start = self.out.len();
        self.pending = written.clone();
        let itself = moves_itself(&place, &value).then(|| whole(place.root));
        let place = self.place_beside(place, itself.as_slice());
        self.pending.clear();
        if self.is_statement(&value) && (self.out.len() > start || moves(&place, &written)) {
            let next = self.wish(Purpose::Part("next"), &value);
            self.keep_at(start, &mut value, &next);
        }
        if disturbs(&place, &value, self.through_pointer(&value)) {
            value = self.keep(value, Purpose::Part("next"));
        }
        // It does nothing, and compilers warn of it.
        if is_own_in_c(&value, &place) || self.has(&place, &value) {
            return;
        }
        self.facts.store(&place, &value, known);
        self.emit(StmtKind::Assign { place, value }, span);
    }

    /// Returns true if a value is a call that must be a statement.
    fn is_statement(&self, value: &Expr) -> bool {
        match &value.kind {
            ExprKind::Call(callee, _) => !self.callees.get(callee.index()).is_some_and(|c| c.nests),
            _ => false,
        }
    }

    /// Returns the parameters that are read early, if a value is a call that returns its result through a pointer.
    fn through_pointer(&self, value: &Expr) -> Option<Early> {
        match &value.kind {
            ExprKind::Call(callee, _) => {
                self.callees.get(callee.index()).and_then(|callee| callee.through_pointer)
            }
            _ => None,
        }
    }

    fn effect(&mut self, expr: Expr, span: Span) {
        match expr.kind {
            ExprKind::Logic(op, condition, effect) => {
                let effect = Stmt { kind: StmtKind::Expr(*effect), span, comments: Vec::new() };
                self.stmt(Stmt {
                    kind: when(op, *condition, vec![effect]),
                    span,
                    comments: Vec::new(),
                });
            }
            _ => {
                let expr = self.lower(expr, Position::Whole, Purpose::Operand);
                if expr.ty.is_aggregate() && !matches!(expr.kind, ExprKind::Call(..)) {
                    return;
                }
                self.facts.forget(&lent(&expr));
                self.emit(StmtKind::Expr(expr), span);
            }
        }
    }

    fn branch(&mut self, condition: Expr, then: Block, otherwise: Block, span: Span) {
        if otherwise.0.is_empty() && matches!(condition.kind, ExprKind::Logic(LogicOp::And, ..)) {
            return self.within(condition, then, span);
        }
        let condition = self.word(condition);
        let condition = self.undecided(condition);
        let other = self.facts.assuming(&condition, false);
        self.facts.assume(&condition, true);
        let then = self.block(then);
        let facts = std::mem::replace(&mut self.facts, other);
        let otherwise = self.block(otherwise);
        let ends = vec![(facts, diverges(&then)), (self.facts.clone(), diverges(&otherwise))];
        self.facts.after(ends);
        self.emit(StmtKind::If { condition, then, otherwise }, span);
    }

    /// Lowers `if a && b { … }` without a flag: statements that `b` needs move into a branch of `a`.
    fn within(&mut self, condition: Expr, then: Block, span: Span) {
        let mut parts = conjuncts(condition).into_iter();
        let Some(mut all) = parts.next().map(|(first, _)| self.word(first)) else { return };
        // The facts if an operand does not hold, and the statements before each branch.
        let (mut ends, mut open) = (Vec::new(), Vec::new());
        for (part, span) in parts {
            let known = self.facts.clone();
            self.facts.assume(&all, true);
            let outer = std::mem::take(&mut self.out);
            let part = self.word(part);
            if self.out.is_empty() {
                (self.out, self.facts) = (outer, known);
                all = Expr { span, ..Expr::logic(LogicOp::And, all, part) };
            } else {
                ends.push((known.assuming(&all, false), false));
                let within = std::mem::replace(&mut self.out, outer);
                let facts = std::mem::replace(&mut self.facts, known);
                let before = self.undecided(std::mem::replace(&mut all, part));
                self.facts = facts;
                open.push((before, std::mem::replace(&mut self.out, within)));
            }
        }
        let condition = self.undecided(all);
        ends.push((self.facts.assuming(&condition, false), false));
        self.facts.assume(&condition, true);
        let then = self.block(then);
        ends.push((self.facts.clone(), diverges(&then)));
        self.facts.after(ends);
        let otherwise = Block::default();
        self.emit(StmtKind::If { condition, then, otherwise }, span);
        while let Some((condition, outer)) = open.pop() {
            let (then, otherwise) =
                (Block(std::mem::replace(&mut self.out, outer)), Block::default());
            self.emit(StmtKind::If { condition, then, otherwise }, span);
        }
    }

    fn select(&mut self, scrutinee: Expr, arms: Vec<Arm>, otherwise: Option<Block>, span: Span) {
        let scrutinee = self.word(scrutinee);
        let before = self.facts.clone();
        let mut ends = Vec::new();
        let mut all = Vec::new();
        let mut done = Vec::new();
        let last = arms.len().saturating_sub(1);
        for (index, Arm { values, body }) in arms.into_iter().enumerate() {
            self.facts = before.clone();
            let rest = otherwise.is_none() && index == last;
            self.facts.select(&scrutinee, &values, rest);
            let body = self.block(body);
            ends.push((self.facts.clone(), diverges(&body)));
            all.extend(values.iter().copied());
            done.push(Arm { values, body });
        }
        let otherwise = otherwise.map(|otherwise| {
            self.facts = before.clone();
            self.facts.exclude(&scrutinee, all);
            let otherwise = self.block(otherwise);
            ends.push((self.facts.clone(), diverges(&otherwise)));
            otherwise
        });
        self.facts = before;
        self.facts.after(ends);
        self.emit(StmtKind::Match { scrutinee, arms: done, otherwise }, span);
    }

    fn repeat(&mut self, kind: StmtKind, span: Span) {
        let StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body } = kind
        else {
            return;
        };
        let name = self.function.local(variable).name.clone();
        let ty = self.function.local(variable).ty.clone();
        let (mut from, mut to) = self.pair(from, to);
        let written = writes(&body.0);
        let changes = |bound: &Expr| reads(bound, &written) || weight(bound) >= 100;
        // Nothing counts a loop that its body ends.
        if changes(&from) && !ended {
            from = self.keep(from, Purpose::Named(&format!("{name}_start")));
        }
        if changes(&to) && !ended {
            to = self.keep(to, Purpose::Named(&format!("{name}_end")));
        }
        let counter = Expr::local(variable, &ty, span);
        let entered = Loop {
            counter: &counter,
            from: &from,
            to: &to,
            inclusive,
            ended,
            written: &written,
            body: &body,
        };
        let behind = entered.enter(&mut self.facts);
        let body = self.block(body);
        self.facts = behind;
        self.emit(
            StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body },
            span,
        );
    }

    /// Lowers a check of the author's.
    fn assertion(&mut self, condition: Expr, fault: Fault, span: Span) {
        // The check of an operation computes its condition at the operation's place, and that never faults.
        self.asked = self.needed.contains(&erased(&condition)).then_some(span);
        let condition = self.word(condition);
        self.asked = None;
        if self.facts.proves(&condition) && !self.doubts(span) {
            // For the verifier to confirm.
            self.emit(StmtKind::Check { condition, fault: Fault::LeftOut }, span);
            return;
        }
        self.facts.assume(&condition, true);
        let reason = match fault {
            Fault::Absent => "the value is not known to be there",
            Fault::Capacity => "the container is not known to have room",
            Fault::Bound => "the loop is not known to end within its bound",
            _ => "the condition is not known to hold",
        };
        self.remain(fault, span, reason.to_string());
        self.emit(StmtKind::Check { condition, fault }, span);
    }

    pub(super) fn remain(&mut self, fault: Fault, span: Span, reason: String) {
        self.remaining.push(Remaining { fault, span, reason });
    }
}

/// Returns the operands of `a && b && c` in order, each with the span of the `&&` before it.
fn conjuncts(condition: Expr) -> Vec<(Expr, Span)> {
    match condition.kind {
        ExprKind::Logic(LogicOp::And, a, b) => {
            let mut parts = conjuncts(*a);
            parts.push((*b, condition.span));
            parts
        }
        _ => vec![(condition.clone(), condition.span)],
    }
}

/// Returns true if control never reaches the end of a block.
pub(super) fn diverges(block: &Block) -> bool {
    block.0.iter().any(|stmt| match &stmt.kind {
        StmtKind::Return(_) | StmtKind::Break | StmtKind::Continue => true,
        // A check that is left out is gone when the passes run on their own output.
        StmtKind::Check { condition, fault } => {
            *fault != Fault::LeftOut && condition.kind == ExprKind::Literal(0)
        }
        StmtKind::If { then, otherwise, .. } => diverges(then) && diverges(otherwise),
        StmtKind::Match { arms, otherwise, .. } => {
            arms.iter().all(|arm| diverges(&arm.body)) && otherwise.as_ref().is_none_or(diverges)
        }
        _ => false,
    })
}

/// Returns true if an assignment leaves a place unchanged in C. `usize` and `u64` are one type there, so a cast between
/// them does nothing.
fn is_own_in_c(value: &Expr, place: &Place) -> bool {
    let form = |ty: &Type| ty.as_int().map(|int| (int.bits(), int.signed()));
    match &value.kind {
        ExprKind::Cast(x) if form(&x.ty).is_some_and(|it| Some(it) == form(&value.ty)) => {
            is_own_in_c(x, place)
        }
        _ => is_own(value, place),
    }
}
