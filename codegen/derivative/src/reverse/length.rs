//! Lengths of the arrays that keep what the passes of a loop compute.
//!
//! A loop with constant bounds has its own length. For another loop a bound is found that no execution without a panic exceeds: a limit of its range,
//! `0..n.min(50)`, or the length of an array from which each pass reads the element of its counter.
//!
//! Must not know: the kept values.

use std::collections::BTreeMap;

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{
    BinaryOp, Block, Expr, ExprKind, Int, Intrinsic, Local, LocalId, Module, Place, Stmt, StmtKind,
    Type,
};

use super::flat::Assigned;
use crate::expression::literal;

/// Largest length of an array for a loop whose own length is not constant.
const MOST: i128 = 1024;

/// Number of operations through which a bound is followed.
const DEPTH: u32 = 16;

/// Values from which bounds follow.
pub struct Bounds<'m> {
    module: &'m Module,
    locals: &'m [Local],
    /// Values of locals that are assigned once.
    values: BTreeMap<LocalId, Expr>,
}

impl<'m> Bounds<'m> {
    /// Returns the values of the locals of a function that are assigned once.
    pub fn of(module: &'m Module, locals: &'m [Local], block: &Block) -> Bounds<'m> {
        let mut declared = Declared::default();
        declared.block(block);
        let mut assigned = Assigned::default();
        assigned.block(block);
        declared.0.retain(|local, _| !assigned.written.contains(local));
        Bounds { module, locals, values: declared.0 }
    }

    /// Returns the smallest value of a loop's counter, and a number of passes that it does not exceed; none if it has no bound.
    pub fn passes(&self, stmt: &Stmt) -> Option<(i128, u32)> {
        let StmtKind::For { variable, from, to, inclusive, body, .. } = &stmt.kind else {
            return None;
        };
        let beyond = i128::from(*inclusive);
        if let (Some(from), Some(to)) = (literal(from), literal(to)) {
            return Some((from, u32::try_from((to + beyond - from).max(1)).ok()?));
        }
        let from =
            literal(from).or_else(|| from.ty.as_int().is_some_and(is_unsigned).then_some(0))?;
        let mut read = Elements { bounds: self, counter: *variable, length: None };
        read.block(body);
        let ends = self.most(to, DEPTH).map(|it| it + beyond).into_iter().chain(read.length);
        let len = (ends.min()? - from).max(1);
        (len <= MOST).then_some((from, u32::try_from(len).ok()?))
    }

    /// Returns a bound that an expression does not exceed, unless it panics.
    fn most(&self, expr: &Expr, depth: u32) -> Option<i128> {
        let depth = depth.checked_sub(1)?;
        let most = |it: &Expr| self.most(it, depth);
        let int = expr.ty.as_int()?;
        let of_type = Some(int).filter(|it| is_unsigned(*it) && it.bits() == 8).map(|_| 255);
        let own = match &expr.kind {
            ExprKind::Literal(_) => literal(expr),
            ExprKind::Load(place) if place.steps.is_empty() => {
                self.values.get(&place.root).and_then(most)
            }
            ExprKind::Cast(of) if of.ty.as_int().is_some_and(is_unsigned) => most(of),
            ExprKind::Intrinsic(Intrinsic::Min, all) => all.iter().filter_map(most).min(),
            ExprKind::Intrinsic(Intrinsic::Clamp, all) => all.last().and_then(most),
            ExprKind::Intrinsic(Intrinsic::Max, all) => {
                all.iter().map(most).collect::<Option<Vec<_>>>()?.into_iter().max()
            }
            ExprKind::Binary(op, a, b) if is_unsigned(int) => match op {
                BinaryOp::Add => Some(most(a)? + most(b)?),
                BinaryOp::Mul => most(a)?.checked_mul(most(b)?),
                BinaryOp::Sub => most(a),
                BinaryOp::Div => literal(b).filter(|it| *it > 0).and_then(|by| Some(most(a)? / by)),
                BinaryOp::Rem => most(b).map(|it| it - 1),
                _ => None,
            },
            _ => None,
        };
        own.into_iter().chain(of_type).min()
    }
}

fn is_unsigned(int: Int) -> bool {
    !int.signed()
}

/// Finds the first values of locals.
#[derive(Default)]
struct Declared(BTreeMap<LocalId, Expr>);

impl Visit for Declared {
    fn stmt(&mut self, stmt: &Stmt) {
        if let StmtKind::Let { local, value: Some(value) } = &stmt.kind {
            self.0.insert(*local, value.clone());
        }
        visit::walk_stmt(self, stmt);
    }
}

/// Finds the shortest array from which each pass reads the element of the counter.
struct Elements<'b, 'm> {
    bounds: &'b Bounds<'m>,
    counter: LocalId,
    length: Option<i128>,
}

impl Visit for Elements<'_, '_> {
    /// Visits what each pass computes: no branch, and no loop within.
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::If { condition, .. } => self.expr(condition),
            StmtKind::Match { scrutinee, .. } => self.expr(scrutinee),
            StmtKind::For { .. } => {}
            _ => visit::walk_stmt(self, stmt),
        }
    }

    /// Visits an expression; the right side of `&&` is not always computed.
    fn expr(&mut self, expr: &Expr) {
        if !matches!(expr.kind, ExprKind::Logic(..)) {
            visit::walk_expr(self, expr);
        }
    }

    fn place(&mut self, place: &Place, _: Access) {
        use bessemer_ir::Step::{Element, Index};
        let mut ty = self.bounds.locals.get(place.root.index()).map(|it| it.ty.clone());
        for step in &place.steps {
            let is_at = |index: &Expr| matches!(&index.kind, ExprKind::Load(at) if at.root == self.counter && at.steps.is_empty());
            let length = match (step, &ty) {
                (Index(index), Some(Type::Array { len, .. })) if is_at(index) => Some(*len),
                (Element(row, _), Some(Type::Matrix { rows, .. })) if is_at(row) => Some(*rows),
                (Element(_, col), Some(Type::Matrix { cols, .. })) if is_at(col) => Some(*cols),
                _ => None,
            };
            self.length = self.length.into_iter().chain(length.map(i128::from)).min();
            ty = ty.and_then(|ty| self.bounds.module.step_type(&ty, step));
        }
        visit::walk_place(self, place);
    }
}
