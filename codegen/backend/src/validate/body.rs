//! Checks of a function's statements.
//!
//! Invariant: a nesting that could overflow the stack is found before anything else visits the body.

use std::collections::BTreeSet;

use bessemer_ir::visit::{Visit, Walk, walk_block, walk_expr, walk_stmt};
use bessemer_ir::{
    Arm, Block, Expr, ExprKind, Function, FunctionId, LocalId, Mode, Module, Span, Stmt, StmtKind,
    Type,
};

use super::flow::{Flow, join};
use super::items::{Sizes, check_span};
use super::problem::{Error, Problem, Subject};

/// Largest nesting of blocks: each `else if` is inside the previous one.
pub const MAX_BLOCKS: u32 = 1024;

/// Largest number of operand levels of an expression: a sum has one for each term.
pub const MAX_HEIGHT: u32 = 4096;

/// Checks one function of a module whose definitions are valid.
pub(super) fn check(module: &Module, sizes: &Sizes<'_>, index: usize) -> Vec<Error> {
    let function = &module.functions[index];
    let mut body = Body {
        module,
        sizes,
        index,
        function,
        flow: Flow::new(function),
        loops: 0,
        declared: Vec::new(),
        errors: Vec::new(),
    };
    let mut depth = Depth { blocks: 0, exprs: 0, deepest: None };
    depth.block(&function.body);
    if let Some(span) = depth.deepest {
        body.note(span, Err(Problem::NestedTooDeep));
        return body.errors;
    }
    let falls_through = body.block(&function.body);
    if falls_through && function.kernel.is_none() && function.result != Type::Unit {
        body.note(function.span, Err(Problem::MissingReturn));
    }
    body.errors
}

/// Nesting of a body; the count stops at the limit.
struct Depth {
    blocks: u32,
    exprs: u32,
    deepest: Option<Span>,
}

impl Visit for Depth {
    fn block(&mut self, block: &Block) {
        if self.blocks <= MAX_BLOCKS {
            self.blocks += 1;
            walk_block(self, block);
            self.blocks -= 1;
        }
    }

    fn stmt(&mut self, stmt: &Stmt) {
        if self.blocks > MAX_BLOCKS {
            self.deepest.get_or_insert(stmt.span);
        }
        walk_stmt(self, stmt);
    }

    fn expr(&mut self, expr: &Expr) {
        if self.exprs >= MAX_HEIGHT {
            self.deepest.get_or_insert(expr.span);
            return;
        }
        self.exprs += 1;
        walk_expr(self, expr);
        self.exprs -= 1;
    }
}

/// Function that is being checked.
pub(super) struct Body<'m> {
    pub module: &'m Module,
    pub sizes: &'m Sizes<'m>,
    /// Index of the function; callees have smaller ones.
    pub index: usize,
    pub function: &'m Function,
    pub flow: Flow,
    /// Number of surrounding loops.
    loops: u32,
    /// Locals that the current block has declared.
    declared: Vec<LocalId>,
    errors: Vec<Error>,
}

impl Body<'_> {
    pub fn note(&mut self, span: Span, result: Result<(), Problem>) {
        if let Err(problem) = result {
            let subject = Subject::Function(FunctionId(self.index as u32));
            self.errors.push(Error { problem, subject, span });
        }
    }

    pub fn expect(&mut self, span: Span, expected: &Type, found: &Type) {
        if expected != found {
            let (expected, found) = (expected.clone(), found.clone());
            self.note(span, Err(Problem::TypeMismatch { expected, found }));
        }
    }

    /// Returns true if the end of the block is reached.
    fn block(&mut self, block: &Block) -> bool {
        let outer = core::mem::take(&mut self.declared);
        let mut falls_through = true;
        for stmt in &block.0 {
            falls_through &= self.stmt(stmt);
        }
        let declared = core::mem::replace(&mut self.declared, outer);
        self.flow.forget(&declared);
        falls_through
    }

    /// Checks alternative blocks; returns true if the end of any is reached.
    fn branches<'b>(&mut self, blocks: impl Iterator<Item = &'b Block>) -> bool {
        let before = self.flow.assigned();
        let mut after: Option<Vec<bool>> = None;
        for block in blocks {
            self.flow.rewind(before.clone());
            if self.block(block) {
                let here = self.flow.assigned();
                after = Some(match after {
                    Some(others) => join(others, &here),
                    None => here,
                });
            }
        }
        let falls_through = after.is_some();
        match after {
            Some(after) => self.flow.rewind(after),
            None => self.flow.diverge(),
        }
        falls_through
    }

    /// Returns true if the statement after this one is reached.
    fn stmt(&mut self, stmt: &Stmt) -> bool {
        self.note(stmt.span, check_span(self.module, stmt.span));
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                if let Some(value) = value {
                    self.value(value);
                    if let Some(declared) = self.function.locals.get(local.index()) {
                        self.expect(value.span, &declared.ty, &value.ty);
                    }
                }
                let is_place =
                    value.as_ref().is_some_and(|it| matches!(it.kind, ExprKind::Load(_)));
                self.name(stmt.span, *local, is_place);
                self.declare(stmt.span, *local, value.is_some(), false);
            }
            StmtKind::Assign { place, value } => {
                self.value(value);
                if self.place(place) {
                    let written = self.flow.write(place.root, place.steps.is_empty());
                    self.note(place.span, written);
                }
                self.expect(value.span, &place.ty, &value.ty);
            }
            StmtKind::Expr(expr) => match expr.kind {
                ExprKind::Call(..) => self.expr(expr),
                _ => self.value(expr),
            },
            StmtKind::If { condition, then, otherwise } => {
                self.condition(condition);
                return self.branches([then, otherwise].into_iter());
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                self.value(scrutinee);
                self.patterns(scrutinee, arms, otherwise.is_some());
                let bodies = arms.iter().map(|arm| &arm.body);
                return self.branches(bodies.chain(otherwise));
            }
            StmtKind::For { variable, from, to, body, .. } => {
                self.repeat(stmt.span, *variable, [from, to], body);
            }
            StmtKind::Check { condition, .. } => {
                self.condition(condition);
                let mut call = None;
                condition.each_expr(|expr| {
                    if let ExprKind::Call(..) = expr.kind {
                        call.get_or_insert(expr.span);
                    }
                });
                if let Some(span) = call {
                    self.note(span, Err(Problem::CallInCheck));
                }
                if matches!(condition.kind, ExprKind::Literal(0)) {
                    self.flow.diverge();
                    return false;
                }
            }
            StmtKind::Return(value) => {
                self.returned(stmt.span, value.as_ref());
                self.flow.diverge();
                return false;
            }
            StmtKind::Break | StmtKind::Continue => {
                if self.loops == 0 {
                    self.note(stmt.span, Err(Problem::OutsideLoop));
                }
                self.flow.diverge();
                return false;
            }
        }
        true
    }

    /// Checks that a local that is an alias begins with a place.
    fn name(&mut self, span: Span, local: LocalId, is_place: bool) {
        let mode = self.function.locals.get(local.index()).map(|local| local.mode);
        if mode == Some(Mode::RefMut) && !is_place {
            self.note(span, Err(Problem::ReferenceLocal(local)));
        }
    }

    fn declare(&mut self, span: Span, local: LocalId, assigned: bool, counter: bool) {
        let result = self.flow.declare(local, assigned, counter);
        if result.is_ok() {
            self.declared.push(local);
        }
        self.note(span, result);
    }

    fn condition(&mut self, condition: &Expr) {
        self.value(condition);
        self.expect(condition.span, &Type::BOOL, &condition.ty);
    }

    fn returned(&mut self, span: Span, value: Option<&Expr>) {
        if value.is_some() == (self.function.result == Type::Unit) {
            self.note(span, Err(Problem::ReturnValue));
        }
        if let Some(value) = value {
            self.value(value);
            if self.function.result != Type::Unit {
                self.expect(value.span, &self.function.result, &value.ty);
            }
        }
    }

    fn patterns(&mut self, scrutinee: &Expr, arms: &[Arm], rest: bool) {
        let (low, high, integer) = match &scrutinee.ty {
            Type::Enum(id) if id.index() < self.module.enums.len() => {
                (0, self.module.enums[id.index()].variants.len() as i128 - 1, false)
            }
            ty => match ty.as_int() {
                Some(int) => (int.min(), int.max(), true),
                None => {
                    self.note(scrutinee.span, Err(Problem::MatchType(ty.clone())));
                    return;
                }
            },
        };
        let mut seen = BTreeSet::new();
        for arm in arms {
            if arm.values.is_empty() {
                self.note(scrutinee.span, Err(Problem::MatchArmEmpty));
            }
            for value in &arm.values {
                if !(low..=high).contains(value) {
                    self.note(scrutinee.span, Err(Problem::MatchValueOutOfRange(*value)));
                } else if !seen.insert(*value) {
                    self.note(scrutinee.span, Err(Problem::MatchValueTwice(*value)));
                }
            }
        }
        if !rest && (integer || seen.len() as i128 <= high) {
            self.note(scrutinee.span, Err(Problem::MatchNotExhaustive));
        }
    }

    fn repeat(&mut self, span: Span, variable: LocalId, bounds: [&Expr; 2], body: &Block) {
        for bound in bounds {
            self.value(bound);
            if let Some(declared) = self.function.locals.get(variable.index()) {
                self.expect(bound.span, &declared.ty, &bound.ty);
            }
            if bound.ty.as_int().is_none() {
                self.note(bound.span, Err(Problem::LoopType(bound.ty.clone())));
            }
        }
        let before = self.flow.assigned();
        let outer = core::mem::take(&mut self.declared);
        self.name(span, variable, false);
        self.declare(span, variable, true, true);
        self.loops += 1;
        self.block(body);
        self.loops -= 1;
        let declared = core::mem::replace(&mut self.declared, outer);
        self.flow.forget(&declared);
        // The body may not run at all.
        self.flow.rewind(before);
    }
}
