//! Verifier of explicit IR: rules F1 to F4 of [`passes`](super), function by function.
//!
//! Precondition: a valid module. F1, F2 and F4 are syntactic. [`proof`](super::proof) proves F3 again, and shares no
//! code with the removal of checks.

use bessemer_ir::StmtKind;
use bessemer_ir::{Argument, Block, Expr, ExprKind, Function, Module, Place, Span, Step, Stmt};
use thiserror::Error;

use super::callees::callees;
use super::places::{disturbs, moves_itself};
use super::positions::{self, Callee, Position, accepts};
use super::sites::Site;
use super::{checked, proof};
use bessemer_ir::effects::{lent, moves, reads, writes};

/// A rule of explicit IR.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum Rule {
    /// An aggregate in a place where F1 does not allow it.
    #[error("an aggregate stands where only a place or a constant may")]
    Aggregate,
    /// A write to a place that is still read (F1).
    #[error("a value is written where it is still read")]
    Overlap,
    /// A call in a place where F2 does not allow it.
    #[error("a call stands within an expression")]
    Call,
    /// An operation without a check that may fault (F3).
    #[error("an operation may fault without a check before it")]
    Unchecked,
    /// Bounds of a loop that change while it runs (F4).
    #[error("a loop changes its own bounds")]
    Bounds,
}

/// A violation of a rule of explicit IR.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{function}` {}:{}: {rule}", .span.line, .span.column)]
pub struct Problem {
    /// The function.
    pub function: String,
    /// Span in the author's source.
    pub span: Span,
    /// Violated rule.
    pub rule: Rule,
}

/// Returns all violations in a valid module.
pub fn check(module: &Module) -> Vec<Problem> {
    let callees = callees(module);
    let (mut problems, mut shown) = (Vec::new(), Vec::new());
    for function in &module.functions {
        let mut checker = Checker { callees: &callees, function, problems };
        checker.block(&function.body);
        let (open, returns) = verified(module, function, &shown);
        open.into_iter().for_each(|site| checker.wrong(Rule::Unchecked, site.span));
        shown.push(returns);
        problems = checker.problems;
    }
    problems
}

struct Checker<'m> {
    callees: &'m [Callee],
    function: &'m Function,
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
            StmtKind::Let { value: Some(value), .. } | StmtKind::Return(Some(value)) => {
                self.expr(value, Position::Whole);
            }
            StmtKind::Assign { place, value } => self.assign(place, value),
            StmtKind::Expr(value) => {
                if value.ty.is_aggregate() && !matches!(value.kind, ExprKind::Call(..)) {
                    self.wrong(Rule::Aggregate, value.span);
                }
                self.expr(value, Position::Whole);
            }
            StmtKind::Check { condition, .. } => self.expr(condition, Position::Nested),
            StmtKind::If { condition, then, otherwise } => {
                self.expr(positions::asked(condition), Position::Decision);
                self.block(then);
                self.block(otherwise);
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                self.expr(scrutinee, Position::Nested);
                arms.iter().map(|arm| &arm.body).chain(otherwise).for_each(|body| self.block(body));
            }
            StmtKind::For { .. } => self.repeat(&stmt.kind, stmt.span),
            StmtKind::Let { value: None, .. }
            | StmtKind::Return(None)
            | StmtKind::Break
            | StmtKind::Continue => {}
        }
    }

    fn assign(&mut self, place: &Place, value: &Expr) {
        self.expr(value, Position::Whole);
        self.place(place);
        let through_pointer = match &value.kind {
            ExprKind::Call(id, _) => {
                self.callees.get(id.index()).and_then(|callee| callee.through_pointer)
            }
            _ => None,
        };
        let moved = moves(place, &lent(value)) || moves_itself(place, value);
        if moved || disturbs(place, value, through_pointer) {
            self.wrong(Rule::Overlap, place.span);
        }
    }

    fn repeat(&mut self, kind: &StmtKind, span: Span) {
        let StmtKind::For { from, to, ended, body, .. } = kind else { return };
        self.expr(from, Position::Nested);
        self.expr(to, Position::Nested);
        let written = writes(&body.0);
        if !ended && (reads(from, &written) || reads(to, &written)) {
            self.wrong(Rule::Bounds, span);
        }
        self.block(body);
    }

    fn expr(&mut self, expr: &Expr, position: Position) {
        if !accepts(self.callees, position, expr) {
            let call = matches!(expr.kind, ExprKind::Call(..));
            self.wrong(if call { Rule::Call } else { Rule::Aggregate }, expr.span);
        }
        self.operands(expr);
    }

    fn operands(&mut self, expr: &Expr) {
        let mut operand = |operand: &Expr| {
            self.expr(operand, positions::operand(&expr.kind, operand));
        };
        match &expr.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => {}
            ExprKind::Load(place) => self.place(place),
            ExprKind::Unary(_, x) | ExprKind::Cast(x) | ExprKind::Splat(x) => operand(x),
            ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) | ExprKind::Logic(_, a, b) => {
                operand(a);
                operand(b);
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
        for step in &place.steps {
            match step {
                Step::Field(_) => {}
                Step::Index(index) | Step::From(index) => self.expr(index, Position::Nested),
                Step::Element(row, column) => {
                    self.expr(row, Position::Nested);
                    self.expr(column, Position::Nested);
                }
            }
        }
    }
}

/// Returns the operations of a function that may fault: neither does [`proof`](super::proof) show that they cannot,
/// nor do their checks precede them. Also returns the function's summary; `shown` are the summaries of earlier
/// functions.
pub(super) fn verified(
    module: &Module,
    function: &Function,
    shown: &[proof::Returns],
) -> (Vec<Site>, proof::Returns) {
    let (open, returns) = proof::open(module, function, shown);
    (checked::without(open, module, function), returns)
}
