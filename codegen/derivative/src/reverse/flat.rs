//! Prepares statements for the way backwards: operands that a slope needs are locals, and no pass of a loop changes what it
//! reads.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, Visit, VisitMut};
use bessemer_ir::{
    BinaryOp, Block, Expr, ExprKind, Intrinsic, LocalId, Place, Step, Stmt, StmtKind,
};

use super::active::Active;
use crate::run::{Run, placeless};
use crate::{Problem, Result};

impl Run<'_> {
    /// Returns prepared statements.
    pub fn flat(&mut self, block: Block, active: &mut Active) -> Result<Block> {
        let (written, ()) = self.captured(|run| {
            for Stmt { kind, span, .. } in block.0 {
                run.flat_stmt(kind, span, active)?;
            }
            Ok(())
        })?;
        Ok(written)
    }

    fn flat_stmt(
        &mut self,
        kind: StmtKind,
        span: bessemer_ir::Span,
        active: &mut Active,
    ) -> Result<()> {
        let kind = match kind {
            StmtKind::Let { local, value: Some(value) } => {
                self.name = self.locals[local.index()].name.clone();
                let value = Some(self.flat_expr(value, true, active));
                StmtKind::Let { local, value }
            }
            StmtKind::Assign { place, value } => {
                self.name = self.locals[place.root.index()].name.clone();
                let value = self.flat_expr(value, false, active);
                StmtKind::Assign { place, value }
            }
            StmtKind::If { condition, then, otherwise } => StmtKind::If {
                condition: self.fixed(condition),
                then: self.flat(then, active)?,
                otherwise: self.flat(otherwise, active)?,
            },
            StmtKind::Match { scrutinee, arms, otherwise } => {
                let scrutinee = self.fixed(scrutinee);
                let mut all = Vec::new();
                for arm in arms {
                    let body = self.flat(arm.body, active)?;
                    all.push(bessemer_ir::Arm { values: arm.values, body });
                }
                let otherwise = otherwise.map(|it| self.flat(it, active)).transpose()?;
                StmtKind::Match { scrutinee, arms: all, otherwise }
            }
            StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, mut body } => {
                self.first_values(&mut body, active);
                let mut leaves = Leaves::default();
                leaves.block(&body);
                if leaves.found {
                    self.last_pass((variable, &from, &to), reversed, &mut body, span);
                }
                let body = self.flat(body, active)?;
                StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body }
            }
            other => other,
        };
        self.emit(kind, span);
        Ok(())
    }

    /// Gives what the passes of a loop assign, and read, locals of a pass.
    fn first_values(&mut self, body: &mut Block, active: &mut Active) {
        let mut assigned = Assigned::default();
        assigned.block(body);
        let outside = assigned.written.difference(&assigned.declared);
        let mut firsts = BTreeMap::new();
        let mut lets = Vec::new();
        for local in outside {
            let declared = self.locals[local.index()].clone();
            if !assigned.read.contains(local) || !declared.ty.is_word() {
                continue;
            }
            let first =
                self.declare(&format!("{}_before", declared.name), &declared.ty, declared.span);
            let value = Some(Expr::local(*local, &declared.ty, declared.span));
            lets.push(Stmt::new(StmtKind::Let { local: first, value }, declared.span));
            firsts.insert(*local, first);
            if active.0.contains(local) {
                active.0.insert(first);
            }
        }
        Renamed(firsts).block(body);
        body.0.splice(0..0, lets);
    }

    /// Counts the passes of a loop that may end early.
    fn last_pass(
        &mut self,
        (variable, from, to): (LocalId, &Expr, &Expr),
        reversed: bool,
        body: &mut Block,
        span: bessemer_ir::Span,
    ) {
        let ty = from.ty.clone();
        let last = self.declare("last", &ty, span);
        let first = if reversed { to } else { from };
        self.emit(StmtKind::Let { local: last, value: Some(first.clone()) }, span);
        let place = Place::local(last, ty.clone(), span);
        let value = Expr::local(variable, &ty, span);
        body.0.insert(0, Stmt::new(StmtKind::Assign { place, value }, span));
        self.ends.insert(variable, last);
    }

    /// Returns a condition that keeps its value: one that reads an array becomes a local.
    fn fixed(&mut self, condition: Expr) -> Expr {
        let mut reads = Assigned::default();
        reads.expr(&condition);
        match reads.parts.iter().any(|local| local.0 >= self.params) {
            true => self.bind("condition", condition),
            false => condition,
        }
    }

    /// Returns an expression whose active products, quotients and functions have atoms for operands. At the top it becomes the
    /// value of a local.
    fn flat_expr(&mut self, expr: Expr, is_top: bool, active: &mut Active) -> Expr {
        if !active.is(&expr) {
            return expr;
        }
        if let ExprKind::Load(place) = &expr.kind {
            return if is_top { expr } else { self.once(place.clone(), active) };
        }
        let Expr { kind, ty, span } = expr;
        let parts = |run: &mut Self, all: Vec<Expr>, active: &mut Active| {
            all.into_iter().map(|it| run.flat_expr(it, false, active)).collect::<Vec<_>>()
        };
        let mut is_own = false;
        let kind = match kind {
            ExprKind::Unary(op, a) => ExprKind::Unary(op, self.flat_box(*a, active)),
            ExprKind::Cast(a) => ExprKind::Cast(self.flat_box(*a, active)),
            ExprKind::Splat(a) => ExprKind::Splat(self.flat_box(*a, active)),
            ExprKind::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), a, b) => {
                ExprKind::Binary(op, self.flat_box(*a, active), self.flat_box(*b, active))
            }
            ExprKind::Binary(op, mut a, mut b) => {
                let (left, right) = (active.is(&a), active.is(&b));
                a = self.flat_box(*a, active);
                b = self.flat_box(*b, active);
                if right || op == BinaryOp::Rem {
                    *a = self.needed(*a, active);
                }
                if left || op != BinaryOp::Mul {
                    *b = self.needed(*b, active);
                }
                is_own = op == BinaryOp::Div && right;
                ExprKind::Binary(op, a, b)
            }
            ExprKind::Intrinsic(op, all) => {
                is_own = true;
                let all = parts(self, all, active);
                let needed = op != Intrinsic::Sqrt;
                let all =
                    all.into_iter().map(|it| if needed { self.needed(it, active) } else { it });
                ExprKind::Intrinsic(op, all.collect())
            }
            ExprKind::Struct(all) => ExprKind::Struct(parts(self, all, active)),
            ExprKind::Array(all) => ExprKind::Array(parts(self, all, active)),
            ExprKind::Matrix(all) => ExprKind::Matrix(parts(self, all, active)),
            // An extreme of matrices, whose elements are compared with it.
            ExprKind::Routine(routine, operands) => {
                let flat = |operand: Expr| {
                    let all = self.elements_of(&operand);
                    let all = parts(self, all, active);
                    let all = all.into_iter().map(|it| self.needed(it, active)).collect();
                    Expr { kind: ExprKind::Matrix(all), ty: operand.ty, span: operand.span }
                };
                ExprKind::Routine(routine, operands.into_iter().map(flat).collect())
            }
            other => other,
        };
        let expr = Expr { kind, ty, span };
        if is_own && !is_top { self.needed(expr, active) } else { expr }
    }

    /// Returns a part of a variable at an unknown index as a local, one for the block and those in it. So its bars are added before
    /// they go to the variable's.
    fn once(&mut self, place: Place, active: &mut Active) -> Expr {
        let is_known = |step: &Step| match step {
            Step::Field(_) => true,
            Step::Index(index) => index.is_literal(),
            Step::Element(row, col) => row.is_literal() && col.is_literal(),
            Step::From(_) => false,
        };
        let load = place.load();
        if place.root.0 >= self.params || place.steps.iter().all(is_known) || !place.ty.is_word() {
            return load;
        }
        let key = placeless(load.clone());
        if let Some((_, local)) = self.calls.iter().find(|it| it.0 == key) {
            return local.clone();
        }
        let name = format!("{}_at", self.locals[place.root.index()].name);
        let local = self.bind(&name, load);
        if let ExprKind::Load(place) = &local.kind {
            active.0.insert(place.root);
        }
        self.calls.push((key, local.clone()));
        local
    }

    fn flat_box(&mut self, expr: Expr, active: &mut Active) -> Box<Expr> {
        Box::new(self.flat_expr(expr, false, active))
    }

    /// Returns a number that the way backwards may read.
    fn needed(&mut self, expr: Expr, active: &mut Active) -> Expr {
        let keeps = match &expr.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => true,
            ExprKind::Load(place) => place.steps.is_empty() || place.root.0 < self.params,
            _ => false,
        };
        if keeps {
            return expr;
        }
        let is_active = active.is(&expr);
        let name = self.name.clone();
        let bound = self.bind(&name, expr);
        if let (true, ExprKind::Load(place)) = (is_active, &bound.kind) {
            active.0.insert(place.root);
        }
        bound
    }
}

/// The problem of a loop whose values cannot be kept.
pub fn unknown_length(span: bessemer_ir::Span) -> Problem {
    Problem::new(
        span,
        "the gradient needs the values of each pass of this loop, whose length is not constant and has no bound of at most 1024",
        "limit the loop, `0..n.min(50)`, or let it have a constant length and end it by `break`",
    )
}

/// Locals that statements declare, write and read.
#[derive(Default)]
pub struct Assigned {
    /// Locals that the statements declare.
    pub declared: BTreeSet<LocalId>,
    /// Locals that the statements write.
    pub written: BTreeSet<LocalId>,
    /// Locals that the statements read.
    pub read: BTreeSet<LocalId>,
    /// Locals of which the statements read a part.
    pub parts: BTreeSet<LocalId>,
}

impl Visit for Assigned {
    fn place(&mut self, place: &Place, access: Access) {
        match access {
            Access::Read => self.read.insert(place.root),
            Access::Write => self.written.insert(place.root),
            Access::Lend => {
                self.read.insert(place.root);
                self.written.insert(place.root)
            }
        };
        if access == Access::Read && !place.steps.is_empty() {
            self.parts.insert(place.root);
        }
        visit::walk_place(self, place);
    }

    fn declaration(&mut self, local: &LocalId) {
        self.declared.insert(*local);
    }
}

/// Renames reads.
struct Renamed(BTreeMap<LocalId, LocalId>);

impl VisitMut for Renamed {
    fn place(&mut self, place: &mut Place, access: Access) {
        if let Some(first) = self.0.get(&place.root).filter(|_| access == Access::Read) {
            place.root = *first;
        }
        visit::walk_place_mut(self, place);
    }
}

#[derive(Default)]
struct Leaves {
    found: bool,
}

impl Visit for Leaves {
    fn stmt(&mut self, stmt: &Stmt) {
        match stmt.kind {
            StmtKind::Break => self.found = true,
            // A loop within is left by its own.
            StmtKind::For { .. } => {}
            _ => visit::walk_stmt(self, stmt),
        }
    }
}
