//! Operations that follow their own checks textually.
//!
//! An operation whose proof is doubted keeps its whole check: all conditions of [`faults`](super::faults). That the
//! check precedes the operation needs no proof: an equal condition comes earlier in the same block, and no statement
//! in between writes what it reads.
//!
//! Must not know: which conditions are proved.

use std::collections::{HashMap, HashSet};

use bessemer_ir::visit::{Access, Visit, walk_expr, walk_stmt};
use bessemer_ir::{
    BinaryOp, Block, Expr, ExprKind, Fault, Function, Int, Module, Place, Step, Stmt, StmtKind,
};

use super::analysis::State;
use super::faults::{self, Obligation};
use super::places::erased;
use super::proof::written::{by_stmts, touches};
use super::sites::Site;

/// Returns true if a statement before a point of a block checks a condition, and it still holds there. `changes`
/// returns true if a statement may change its value; the remover of checks and the verifier each pass their own
/// function.
pub(super) fn before(
    stmts: &[Stmt],
    condition: &Expr,
    changes: impl Fn(&Stmt, &Expr) -> bool,
) -> bool {
    let condition = erased(condition);
    for stmt in stmts.iter().rev() {
        if let StmtKind::Check { condition: checked, fault } = &stmt.kind
            && *fault != Fault::LeftOut
            && erased(checked) == condition
        {
            return true;
        }
        if changes(stmt, &condition) {
            return false;
        }
    }
    false
}

/// Returns true if a statement may change a condition, according to the proof's own list of written places.
fn changes(stmt: &Stmt, condition: &Expr) -> bool {
    touches(condition, &by_stmts([stmt]))
}

/// Returns those operations of a function that may fault without a check before them.
pub(super) fn without(open: Vec<Site>, module: &Module, function: &Function) -> Vec<Site> {
    if open.is_empty() {
        return open;
    }
    let found = found(module, function);
    open.into_iter().filter(|site| !found.stands(site)).collect()
}

/// Returns the conditions of checks that later operations need.
pub(super) fn needed(module: &Module, function: &Function) -> Vec<Expr> {
    found(module, function).checks.into_iter().map(|check| check.condition).collect()
}

fn found(module: &Module, function: &Function) -> Found {
    let blind = State::blind(module);
    let mut blocks = Blocks { blind, module, function, found: Found::default() };
    blocks.block(&function.body);
    blocks.found
}

#[derive(Default)]
struct Found {
    checks: Vec<Needed>,
    /// Operations that follow their checks.
    checked: HashSet<Site>,
    /// Operations inside the condition of a check.
    within: HashMap<Site, Part>,
}

/// A condition that an operation needs and that was checked.
struct Needed {
    condition: Expr,
    /// Operands of the operation that may fault.
    operands: Vec<Expr>,
}

/// An operation in the condition of a check; `of` is its expression, none for a step.
struct Part {
    condition: Expr,
    of: Option<Expr>,
}

impl Found {
    /// Returns true if an operation cannot fault in its position. It is checked, or it is part of a check of another
    /// operation (`x <= MAX / y`, where `y` is above 0), which never faults.
    fn stands(&self, site: &Site) -> bool {
        let asks = |Part { condition, of }: &Part| {
            let Some(of) = of else { return false };
            let mut checks = self.checks.iter().filter(|check| check.condition == *condition);
            checks.any(|check| !check.operands.contains(of))
        };
        self.checked.contains(site) || self.within.get(site).is_some_and(asks)
    }
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
            let within = match &stmt.kind {
                StmtKind::Check { condition, .. } => Some(erased(condition)),
                _ => None,
            };
            let stmts = &block.0[..at];
            walk_stmt(&mut Operations { of: self, stmts, within, seen: Vec::new() }, stmt);
            walk_stmt(self, stmt);
        }
    }
    fn expr(&mut self, _: &Expr) {}
}

/// Visitor of the operations of one statement, without its inner blocks.
struct Operations<'a, 'm> {
    of: &'a mut Blocks<'m>,
    /// Statements of the block before it.
    stmts: &'a [Stmt],
    /// The condition, if it is a check.
    within: Option<Expr>,
    /// Expressions so far that could fault, without steps.
    seen: Vec<Expr>,
}

impl Operations<'_, '_> {
    /// Visits an operation. `of` is its expression, none for a step; its operands begin at index `operands` of
    /// `seen`.
    fn operation(&mut self, site: Site, needs: &[Obligation], of: Option<Expr>, operands: usize) {
        let found = &mut self.of.found;
        if needs.iter().all(|it| before(self.stmts, &it.condition, changes)) {
            found.checked.insert(site);
            found.checks.extend(needs.iter().map(|it| Needed {
                condition: erased(&it.condition),
                operands: self.seen[operands..].to_vec(),
            }));
        }
        if let Some(condition) = self.within.clone() {
            found.within.insert(site, Part { condition, of: of.clone() });
        }
        self.seen.extend(of);
    }
}

impl Visit for Operations<'_, '_> {
    fn block(&mut self, _: &Block) {}
    fn expr(&mut self, expr: &Expr) {
        let operands = self.seen.len();
        walk_expr(self, expr);
        let needs = faults::of_expr(expr, &self.of.blind);
        if is_rest(expr) {
            self.of.found.checked.insert(Site::of_expr(expr));
        } else if !needs.is_empty() {
            self.operation(Site::of_expr(expr), &needs, Some(erased(expr)), operands);
        }
    }
    fn place(&mut self, place: &Place, _: Access) {
        let mut container = Some(self.of.function.local(place.root).ty.clone());
        for step in &place.steps {
            let Some(ty) = &container else { break };
            let operands = self.seen.len();
            match step {
                Step::Field(_) => {}
                Step::Index(index) | Step::From(index) => self.expr(index),
                Step::Element(row, column) => {
                    self.expr(row);
                    self.expr(column);
                }
            }
            let needs = faults::of_step(place.root, ty, step, &self.of.blind);
            if !needs.is_empty() {
                self.operation(Site::of_step(step, place.span), &needs, None, operands);
            }
            container = self.of.module.step_type(ty, step);
        }
    }
}

/// Returns true for the largest number of an unsigned type minus another, which cannot fault. Checks of sums have it.
fn is_rest(expr: &Expr) -> bool {
    let ExprKind::Binary(BinaryOp::Sub, all, _) = &expr.kind else { return false };
    let unsigned = expr.ty.as_int().filter(|int| Int::min(*int) == 0);
    let largest = unsigned.map(|int| ExprKind::Literal(int.max() as u64));
    largest.is_some_and(|largest| all.kind == largest)
}

#[cfg(test)]
mod tests;
