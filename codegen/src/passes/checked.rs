//! Operations that stand behind their own checks, as they are written.
//!
//! An operation whose proof is doubted keeps its whole check: all conditions of [`faults`](super::faults), of which
//! nothing is left out. Whether that check stands before it shows by its text alone, and needs no proof: the same
//! condition, earlier in the same block, and nothing that it reads is written in between.
//!
//! Must not know: what is proved.

use std::collections::HashSet;

use bessemer_ir::visit::{Access, Visit, walk_expr, walk_place, walk_stmt};
use bessemer_ir::{Block, Expr, ExprKind, Fault, Function, Module, Place, Span, Stmt, StmtKind};

use super::analysis::State;
use super::faults::{self, Obligation};
use super::places::{erased, reads, writes};

/// Whether a condition was checked by the statements before a point of a block, and still holds there.
pub(super) fn before(stmts: &[Stmt], condition: &Expr) -> bool {
    let condition = erased(condition);
    for stmt in stmts.iter().rev() {
        if let StmtKind::Check { condition: checked, fault } = &stmt.kind
            && *fault != Fault::LeftOut
            && erased(checked) == condition
        {
            return true;
        }
        if reads(&condition, &writes([stmt])) {
            return false;
        }
    }
    false
}

/// Of places in a function at which something may fault: those where more stands than operations behind their checks.
pub(super) fn without(open: Vec<Span>, module: &Module, function: &Function) -> Vec<Span> {
    if open.is_empty() {
        return open;
    }
    let Found { checks, checked, bare } = found(module, function);
    // A condition that an operation needs cannot fault itself.
    let faults = |within: &Option<Expr>| !within.as_ref().is_some_and(|it| checks.contains(it));
    let bare = |span: &Span| bare.iter().any(|(at, within)| at == span && faults(within));
    open.into_iter().filter(|span| bare(span) || !checked.contains(span)).collect()
}

/// The conditions of checks that operations behind them need, of words alone.
pub(super) fn needed(module: &Module, function: &Function) -> Vec<Expr> {
    let mut checks = found(module, function).checks;
    checks.retain(|condition| {
        let mut words = Words(true);
        words.expr(condition);
        words.0
    });
    checks
}

/// Whether an expression neither calls nor takes what has parts.
struct Words(bool);

impl Visit for Words {
    fn expr(&mut self, expr: &Expr) {
        self.0 &=
            expr.ty.is_word() && !matches!(expr.kind, ExprKind::Call(..) | ExprKind::Routine(..));
        walk_expr(self, expr);
    }
}

fn found(module: &Module, function: &Function) -> Found {
    let blind = State::blind(module);
    let mut blocks = Blocks { blind, module, function, found: Found::default() };
    blocks.block(&function.body);
    blocks.found
}

#[derive(Default)]
struct Found {
    /// Conditions that operations needed and found checked.
    checks: Vec<Expr>,
    /// Where an operation stands behind its check.
    checked: HashSet<Span>,
    /// Where one does not; and the condition that it is part of, if that is checked.
    bare: Vec<(Span, Option<Expr>)>,
}

struct Blocks<'m> {
    blind: State<'m>,
    module: &'m Module,
    function: &'m Function,
    found: Found,
}

impl Visit for Blocks<'_> {
    fn block(&mut self, block: &Block) {
        for (at, stmt) in block.0.iter().enumerate() {
            if let StmtKind::Check { fault: Fault::LeftOut, .. } = stmt.kind {
                self.found.bare.push((stmt.span, None));
            }
            let within = match &stmt.kind {
                StmtKind::Check { condition, .. } => Some(erased(condition)),
                _ => None,
            };
            let stmts = &block.0[..at];
            walk_stmt(&mut Operations { of: self, stmts, within }, stmt);
            walk_stmt(self, stmt);
        }
    }
    fn expr(&mut self, _: &Expr) {}
}

/// The operations of one statement, without those of its blocks.
struct Operations<'a, 'm> {
    of: &'a mut Blocks<'m>,
    /// Those of the block before it.
    stmts: &'a [Stmt],
    /// The condition, if it is a check.
    within: Option<Expr>,
}

impl Operations<'_, '_> {
    fn operation(&mut self, span: Span, needs: Vec<Obligation>) {
        let found = &mut self.of.found;
        if !needs.iter().all(|it| before(self.stmts, &it.condition)) {
            found.bare.push((span, self.within.clone()));
        } else if !needs.is_empty() {
            found.checked.insert(span);
            found.checks.extend(needs.iter().map(|it| erased(&it.condition)));
        }
    }
}

impl Visit for Operations<'_, '_> {
    fn block(&mut self, _: &Block) {}
    fn expr(&mut self, expr: &Expr) {
        self.operation(expr.span, faults::of_expr(expr, &self.of.blind));
        walk_expr(self, expr);
    }
    fn place(&mut self, place: &Place, _: Access) {
        let mut container = Some(self.of.function.local(place.root).ty.clone());
        for step in &place.steps {
            let Some(ty) = &container else { break };
            self.operation(place.span, faults::of_step(place.root, ty, step, &self.of.blind));
            container = faults::step_type(self.of.module, ty, step);
        }
        walk_place(self, place);
    }
}
