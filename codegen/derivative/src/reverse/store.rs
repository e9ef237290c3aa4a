//! Keeps values of the way forwards for the way backwards. Those of a branch are in a local, and those of a loop in an array of
//! its length.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, Visit, VisitMut};
use bessemer_ir::{
    BinaryOp, Block, Expr, ExprKind, LocalId, Place, Span, Step, Stmt, StmtKind, Type,
};

use super::flat::{Assigned, unknown_length};
use super::length::Bounds;
use crate::Result;
use crate::run::Run;

/// A loop around a declaration: its counter, its smallest value and the number of passes, if they have bounds.
#[derive(Clone)]
struct Around {
    counter: Expr,
    length: Option<(i128, u32)>,
    span: Span,
}

/// A declaration within a branch or a loop.
struct Declared {
    around: Vec<Around>,
    value: Option<Expr>,
}

/// Declarations within branches and loops.
struct Nested<'m> {
    bounds: Bounds<'m>,
    depth: usize,
    around: Vec<Around>,
    found: BTreeMap<LocalId, Declared>,
    counters: BTreeSet<LocalId>,
}

impl Visit for Nested<'_> {
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { local, value } if self.depth > 0 => {
                let declared = Declared { around: self.around.clone(), value: value.clone() };
                self.found.insert(*local, declared);
            }
            StmtKind::For { variable, from, body, .. } => {
                let length = self.bounds.passes(stmt);
                let counter = Expr::local(*variable, &from.ty, stmt.span);
                self.around.push(Around { counter, length, span: stmt.span });
                self.counters.insert(*variable);
                self.depth += 1;
                self.block(body);
                self.depth -= 1;
                self.around.pop();
            }
            StmtKind::If { .. } | StmtKind::Match { .. } => {
                self.depth += 1;
                visit::walk_stmt(self, stmt);
                self.depth -= 1;
            }
            _ => {}
        }
    }
}

/// Joins the two ways.
pub fn kept(run: &mut Run<'_>, mut forwards: Block, mut backwards: Block) -> Result<Block> {
    let mut reads = Assigned::default();
    reads.block(&backwards);
    let mut nested = Nested {
        bounds: Bounds::of(run.module, &run.locals, &forwards),
        depth: 0,
        around: Vec::new(),
        found: BTreeMap::new(),
        counters: BTreeSet::new(),
    };
    nested.block(&forwards);
    let Nested { found, counters, .. } = nested;
    let mut assigned = Assigned::default();
    assigned.block(&forwards);
    let mut first = Vec::new();
    let mut homes: BTreeMap<LocalId, Expr> = BTreeMap::new();
    let mut stores: BTreeMap<LocalId, Place> = BTreeMap::new();
    let mut hoisted = BTreeSet::new();
    let mut needed: Vec<LocalId> = reads.read.difference(&reads.declared).copied().collect();
    let mut known = BTreeSet::new();
    while let Some(local) = needed.pop() {
        let Some(declared) = found.get(&local).filter(|_| known.insert(local)) else {
            continue;
        };
        let local = &local;
        let of = run.locals[local.index()].clone();
        // What a loop or a call changes later is no longer its first value.
        let value = declared.value.as_ref().filter(|_| !assigned.written.contains(local));
        if let Some(value) = value.filter(|it| run.is_cheap(it, &counters)) {
            let mut operands = Assigned::default();
            operands.expr(value);
            needed.extend(operands.read);
            homes.insert(*local, value.clone());
            continue;
        }
        if declared.around.is_empty() {
            let zero = run.zero(&of.ty, of.span);
            first.push(Stmt::new(StmtKind::Let { local: *local, value: Some(zero) }, of.span));
            hoisted.insert(*local);
            continue;
        }
        let mut ty = of.ty.clone();
        let mut steps = Vec::new();
        for around in declared.around.iter().rev() {
            let Some((from, len)) = around.length else {
                return Err(unknown_length(around.span));
            };
            ty = Type::Array { element: Box::new(ty), len };
            let mut index = around.counter.clone();
            if from != 0 {
                let from = Expr::literal_like(from as u64, &index);
                index = Expr::binary(BinaryOp::Sub, index, from);
            }
            if index.ty != Type::USIZE {
                index = index.cast(&Type::USIZE);
            }
            steps.insert(0, Step::Index(index));
        }
        let zero = run.zero(&ty, of.span);
        let name = format!("{}_kept", of.name.trim_end_matches("_before"));
        let store = run.declare(&name, &ty, of.span);
        first.push(Stmt::new(StmtKind::Let { local: store, value: Some(zero) }, of.span));
        let place = Place { root: store, steps, ty: of.ty.clone(), span: of.span };
        homes.insert(*local, place.load());
        stores.insert(*local, place);
    }
    Moved(&homes).block(&mut backwards);
    hoist(&mut forwards, &hoisted);
    written(&mut forwards, &stores);
    let mut body = Block(first);
    body.0.extend(forwards.0);
    body.0.extend(backwards.0);
    Ok(body)
}

impl Run<'_> {
    /// Returns true if a value is computed again instead of kept. It is a part of a parameter at a counter, or an operation
    /// on that or a literal, and a local.
    fn is_cheap(&self, value: &Expr, counters: &BTreeSet<LocalId>) -> bool {
        let is_local = |it: &Expr| match &it.kind {
            ExprKind::Load(place) => place.steps.is_empty() && place.root.0 >= self.params,
            _ => false,
        };
        let is_known = |it: &Expr| self.is_known(it, counters);
        match &value.kind {
            ExprKind::Unary(_, a) => is_local(a) || is_known(a),
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul, a, b) => {
                value.ty.as_float().is_some()
                    && (is_known(a) || is_known(b))
                    && (is_known(a) || is_local(a))
                    && (is_known(b) || is_local(b))
            }
            _ => is_known(value),
        }
    }

    /// Returns true for a literal, a part of a parameter at a counter, and sums and products of these.
    fn is_known(&self, value: &Expr, counters: &BTreeSet<LocalId>) -> bool {
        let index = |index: &Expr| match &index.kind {
            ExprKind::Literal(_) => true,
            ExprKind::Load(place) => counters.contains(&place.root) && place.steps.is_empty(),
            _ => false,
        };
        let is_at = |step: &Step| match step {
            Step::Field(_) => true,
            Step::Index(at) => index(at),
            Step::Element(row, col) => index(row) && index(col),
            Step::From(_) => false,
        };
        match &value.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => true,
            ExprKind::Load(place) => place.root.0 < self.params && place.steps.iter().all(is_at),
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul, a, b) => {
                value.ty.as_float().is_some()
                    && self.is_known(a, counters)
                    && self.is_known(b, counters)
            }
            _ => false,
        }
    }
}

/// Reads kept values where they are.
struct Moved<'h>(&'h BTreeMap<LocalId, Expr>);

impl VisitMut for Moved<'_> {
    fn expr(&mut self, expr: &mut Expr) {
        visit::walk_expr_mut(self, expr);
        let ExprKind::Load(place) = &expr.kind else { return };
        let Some(home) = self.0.get(&place.root) else { return };
        match &home.kind {
            ExprKind::Load(at) => {
                let mut moved = at.clone();
                moved.steps.extend(place.steps.iter().cloned());
                moved.ty = place.ty.clone();
                *expr = Expr { kind: ExprKind::Load(moved), ..expr.clone() };
            }
            other if place.steps.is_empty() => expr.kind = other.clone(),
            _ => return,
        }
        // The expression put in may read kept locals, too.
        self.expr(expr);
    }

    fn place(&mut self, place: &mut Place, _: Access) {
        visit::walk_place_mut(self, place);
    }
}

/// Assigns locals where they were declared.
fn hoist(block: &mut Block, locals: &BTreeSet<LocalId>) {
    block.0.retain_mut(|stmt| {
        let span = stmt.span;
        match &mut stmt.kind {
            StmtKind::Let { local, value } if locals.contains(local) => {
                let Some(value) = value.take() else { return false };
                let place = Place::local(*local, value.ty.clone(), span);
                stmt.kind = StmtKind::Assign { place, value };
            }
            kind => inner(kind, &mut |block| hoist(block, locals)),
        }
        true
    });
}

/// Stores locals behind the last statement of their block that writes them.
fn written(block: &mut Block, stores: &BTreeMap<LocalId, Place>) {
    let mut last: BTreeMap<LocalId, usize> = BTreeMap::new();
    for (at, stmt) in block.0.iter_mut().enumerate() {
        if let StmtKind::Let { local, .. } = &stmt.kind
            && stores.contains_key(local)
        {
            last.insert(*local, at);
        }
        let mut writes = Assigned::default();
        writes.stmt(stmt);
        for local in &writes.written {
            if let Some(last) = last.get_mut(local) {
                *last = at;
            }
        }
        inner(&mut stmt.kind, &mut |block| written(block, stores));
    }
    let mut order: Vec<(usize, LocalId)> =
        last.into_iter().map(|(local, at)| (at, local)).collect();
    order.sort_unstable();
    for (at, local) in order.into_iter().rev() {
        let place = stores[&local].clone();
        let value = Expr::local(local, &place.ty, place.span);
        let span = place.span;
        block.0.insert(at + 1, Stmt::new(StmtKind::Assign { place, value }, span));
    }
}

/// Calls a function on the blocks of a statement.
fn inner(kind: &mut StmtKind, each: &mut dyn FnMut(&mut Block)) {
    match kind {
        StmtKind::If { then, otherwise, .. } => {
            each(then);
            each(otherwise);
        }
        StmtKind::Match { arms, otherwise, .. } => {
            arms.iter_mut().for_each(|arm| each(&mut arm.body));
            otherwise.iter_mut().for_each(each);
        }
        StmtKind::For { body, .. } => each(body),
        _ => {}
    }
}
