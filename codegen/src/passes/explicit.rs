//! The verifier of explicit IR: F1 to F4 of [`passes`](super), function by function.
//!
//! Precondition: a valid module. It walks the statements with the same [`Facts`] as the pass, but reads
//! them off the explicit IR alone: what is proved here is proved for the C back end.

use bessemer_ir::{Argument, Block, Expr, ExprKind, Function, Module, Place, Span, Step, Stmt};
use bessemer_ir::{LogicOp, StmtKind};
use thiserror::Error;

use super::counts::Loop;
use super::facts::Facts;
use super::faults::{of_expr, of_step, step_type};
use super::places::{disturbs, lent, load, moves, reads, whole, writes};
use super::positions::{self, Callee, Position, accepts};
use super::statements::diverges;

/// A rule of explicit IR.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum Rule {
    /// F1.
    #[error("an aggregate stands where only a place or a constant may")]
    Aggregate,
    /// F1.
    #[error("a value is written where it is still read")]
    Overlap,
    /// F2.
    #[error("a call stands within an expression")]
    Call,
    /// F3.
    #[error("an operation may fault without a check before it")]
    Unchecked,
    /// F4.
    #[error("a loop changes its own bounds")]
    Bounds,
}

/// A place where a module is not explicit.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{function}` {}:{}: {rule}", .span.line, .span.column)]
pub struct Problem {
    /// The function.
    pub function: String,
    /// Where in the author's source.
    pub span: Span,
    /// What is broken.
    pub rule: Rule,
}

/// Everything that is not explicit in a valid module.
pub fn check(module: &Module) -> Vec<Problem> {
    let callees = super::callees(module);
    let mut problems = Vec::new();
    for function in &module.functions {
        let facts = Facts::new(module);
        let mut checker = Checker { callees: &callees, function, facts, problems };
        checker.block(&function.body);
        problems = checker.problems;
    }
    problems
}

struct Checker<'m> {
    callees: &'m [Callee],
    function: &'m Function,
    facts: Facts<'m>,
    problems: Vec<Problem>,
}

impl Checker<'_> {
    fn wrong(&mut self, rule: Rule, span: Span) {
        self.problems.push(Problem { function: self.function.name.clone(), span, rule });
    }

    fn block(&mut self, block: &Block) {
        block.0.iter().for_each(|stmt| self.stmt(stmt));
    }

    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                let known = value.as_ref().and_then(|value| self.whole(value));
                self.facts.assign(&whole(*local), known);
            }
            StmtKind::Assign { place, value } => self.assign(place, value),
            StmtKind::Expr(value) => {
                if value.ty.is_aggregate() && !matches!(value.kind, ExprKind::Call(..)) {
                    self.wrong(Rule::Aggregate, value.span);
                }
                self.whole(value);
            }
            StmtKind::Return(Some(value)) => {
                self.whole(value);
            }
            StmtKind::Check { condition, .. } => {
                self.expr(condition, Position::Nested);
                self.facts.assume(condition, true);
            }
            StmtKind::If { condition, then, otherwise } => self.branch(condition, then, otherwise),
            StmtKind::Match { .. } => self.select(&stmt.kind),
            StmtKind::For { .. } => self.repeat(&stmt.kind, stmt.span),
            StmtKind::Return(None) | StmtKind::Break | StmtKind::Continue => {}
        }
    }

    /// A whole value; after it, what it writes is forgotten.
    fn whole(&mut self, value: &Expr) -> Option<super::facts::Known> {
        self.expr(value, Position::Whole);
        let known = self.facts.value(value);
        self.facts.forget(&lent(value));
        known
    }

    fn assign(&mut self, place: &Place, value: &Expr) {
        let known = self.whole(value);
        self.place(place);
        let through_pointer = match &value.kind {
            ExprKind::Call(id, _) => {
                self.callees.get(id.index()).is_some_and(|callee| callee.through_pointer)
            }
            _ => false,
        };
        if moves(place, &lent(value)) || disturbs(place, value, through_pointer) {
            self.wrong(Rule::Overlap, place.span);
        }
        self.facts.assign(place, known);
    }

    fn branch(&mut self, condition: &Expr, then: &Block, otherwise: &Block) {
        self.expr(condition, Position::Nested);
        let other = self.facts.assuming(condition, false);
        self.facts.assume(condition, true);
        self.block(then);
        let facts = std::mem::replace(&mut self.facts, other);
        self.block(otherwise);
        let ends = vec![(facts, diverges(then)), (self.facts.clone(), diverges(otherwise))];
        self.facts.after(ends);
    }

    fn select(&mut self, kind: &StmtKind) {
        let StmtKind::Match { scrutinee, arms, otherwise } = kind else { return };
        self.expr(scrutinee, Position::Nested);
        let before = self.facts.clone();
        let mut ends = Vec::new();
        for arm in arms {
            self.facts = before.clone();
            self.facts.select(scrutinee, &arm.values);
            self.block(&arm.body);
            ends.push((self.facts.clone(), diverges(&arm.body)));
        }
        if let Some(otherwise) = otherwise {
            self.facts = before.clone();
            let values = arms.iter().flat_map(|arm| arm.values.iter().copied()).collect();
            self.facts.exclude(scrutinee, values);
            self.block(otherwise);
            ends.push((self.facts.clone(), diverges(otherwise)));
        }
        self.facts = before;
        self.facts.after(ends);
    }

    fn repeat(&mut self, kind: &StmtKind, span: Span) {
        let StmtKind::For { variable, from, to, inclusive, ended, body, .. } = kind else { return };
        self.expr(from, Position::Nested);
        self.expr(to, Position::Nested);
        let written = writes(&body.0);
        if !ended && (reads(from, &written) || reads(to, &written)) {
            self.wrong(Rule::Bounds, span);
        }
        let ranges = (self.facts.range(from), self.facts.range(to));
        let entered = Loop {
            variable: *variable,
            bounds: ranges,
            inclusive: *inclusive,
            ended: *ended,
            written: &written,
            body,
        };
        let behind = entered.enter(&mut self.facts);
        let counter = load(*variable, &self.function.local(*variable).ty, span);
        self.facts.enter_body(&counter, (from, to), ranges, *inclusive);
        self.block(body);
        self.facts = behind;
    }

    fn expr(&mut self, expr: &Expr, position: Position) {
        if !accepts(self.callees, position, expr) {
            let call = matches!(expr.kind, ExprKind::Call(..));
            self.wrong(if call { Rule::Call } else { Rule::Aggregate }, expr.span);
        }
        self.operands(expr);
        if !of_expr(expr, &self.facts).is_empty() {
            self.wrong(Rule::Unchecked, expr.span);
        }
    }

    fn operands(&mut self, expr: &Expr) {
        let mut operand = |operand: &Expr| {
            self.expr(operand, positions::operand(&expr.kind, operand));
        };
        match &expr.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => {}
            ExprKind::Load(place) => self.place(place),
            ExprKind::Unary(_, x) | ExprKind::Cast(x) | ExprKind::Splat(x) => operand(x),
            ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => {
                operand(a);
                operand(b);
            }
            ExprKind::Logic(op, a, b) => {
                operand(a);
                let facts = self.facts.assuming(a, *op == LogicOp::And);
                let before = std::mem::replace(&mut self.facts, facts);
                self.expr(b, Position::Nested);
                self.facts = before;
            }
            ExprKind::Intrinsic(_, operands)
            | ExprKind::Struct(operands)
            | ExprKind::Array(operands)
            | ExprKind::Matrix(operands)
            | ExprKind::Routine(_, operands) => operands.iter().for_each(operand),
            ExprKind::Call(_, arguments) => self.arguments(arguments),
        }
    }

    fn arguments(&mut self, arguments: &[Argument]) {
        let mut lent = Vec::new();
        for argument in arguments {
            if let Argument::RefMut(place) = argument {
                self.place(place);
                lent.push(place.clone());
            } else if let Some((value, position)) = positions::argument(argument) {
                self.expr(value, position);
            }
        }
        for argument in arguments {
            if let Argument::Value(value) = argument
                && value.ty.is_aggregate()
                && reads(value, &lent)
            {
                self.wrong(Rule::Overlap, value.span);
            }
        }
    }

    fn place(&mut self, place: &Place) {
        let mut container = Some(self.function.local(place.root).ty.clone());
        for step in &place.steps {
            match step {
                Step::Field(_) => {}
                Step::Index(index) | Step::From(index) => self.expr(index, Position::Nested),
                Step::Element(row, column) => {
                    self.expr(row, Position::Nested);
                    self.expr(column, Position::Nested);
                }
            }
            if let Some(container) = &container
                && !of_step(place.root, container, step, &self.facts).is_empty()
            {
                self.wrong(Rule::Unchecked, place.span);
            }
            container =
                container.and_then(|container| step_type(self.facts.module(), &container, step));
        }
    }
}
