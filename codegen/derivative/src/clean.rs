//! Removes what the value and the Jacobians do not need, and makes the names of locals unique.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{Block, Expr, ExprKind, Function, LocalId, Place, Step, Stmt, StmtKind, Type};

/// Removes assignments of locals that are never read, and branches and loops that then are empty; renames locals.
pub fn clean(function: &mut Function) {
    loop {
        let mut reads = Reads::default();
        reads.block(&function.body);
        if !swept(&mut function.body, &reads, function.params) {
            break;
        }
    }
    name(function);
}

/// Gives each local a name that is a name in Rust, and its own.
fn name(function: &mut Function) {
    let mut used: BTreeSet<String> = BTreeSet::new();
    let mut counts: BTreeMap<String, u32> = BTreeMap::new();
    for (index, local) in function.locals.iter_mut().enumerate() {
        let base = if index < function.params as usize {
            local.name.clone()
        } else {
            crate::rust::identifier(&local.name)
        };
        let mut name = base.clone();
        while used.contains(&name) {
            let count = counts.entry(base.clone()).or_insert(1);
            *count += 1;
            name = format!("{base}_{count}");
        }
        used.insert(name.clone());
        local.name = name;
    }
}

/// Locals that are read, and those that calls change.
#[derive(Default)]
struct Reads {
    read: BTreeSet<LocalId>,
    changed_by_calls: BTreeSet<LocalId>,
}

impl Reads {
    /// Returns true if a call changes a local that is read.
    fn lends(&self, expr: &Expr) -> bool {
        let mut own = Reads::default();
        own.expr(expr);
        own.changed_by_calls.iter().any(|local| self.read.contains(local))
    }
}

impl Visit for Reads {
    fn place(&mut self, place: &Place, access: Access) {
        match access {
            Access::Read => self.read.insert(place.root),
            Access::Lend => self.changed_by_calls.insert(place.root),
            Access::Write => false,
        };
        visit::walk_place(self, place);
    }
}

/// Removes statements whose results nothing reads; returns true if it found one.
fn swept(block: &mut Block, reads: &Reads, params: u32) -> bool {
    let Reads { read, changed_by_calls } = reads;
    let before = block.0.len();
    let mut changed = false;
    block.0.retain_mut(|stmt: &mut Stmt| match &mut stmt.kind {
        StmtKind::Let { local, value } => {
            let needed = |it: &Expr| may_fault(it) || reads.lends(it);
            read.contains(local)
                || changed_by_calls.contains(local)
                || value.as_ref().is_some_and(needed)
        }
        StmtKind::Assign { place, value } => {
            place.root.0 < params
                || read.contains(&place.root)
                || changed_by_calls.contains(&place.root)
                || may_fault(value)
                || place_may_fault(place)
        }
        StmtKind::If { condition, then, otherwise } => {
            changed |= swept(then, reads, params);
            changed |= swept(otherwise, reads, params);
            !then.0.is_empty() || !otherwise.0.is_empty() || may_fault(condition)
        }
        StmtKind::Match { arms, otherwise, .. } => {
            for arm in arms.iter_mut() {
                changed |= swept(&mut arm.body, reads, params);
            }
            if let Some(otherwise) = otherwise {
                changed |= swept(otherwise, reads, params);
            }
            let empty = |block: &Block| block.0.is_empty();
            !arms.iter().all(|arm| empty(&arm.body)) || !otherwise.as_ref().is_none_or(empty)
        }
        StmtKind::For { from, to, body, .. } => {
            changed |= swept(body, reads, params);
            !body.0.is_empty() || may_fault(from) || may_fault(to)
        }
        StmtKind::Expr(expr) => may_fault(expr) || reads.lends(expr),
        _ => true,
    });
    changed || block.0.len() != before
}

fn place_may_fault(place: &Place) -> bool {
    place.steps.iter().any(|step| match step {
        Step::Field(_) => false,
        Step::Index(index) | Step::From(index) => !index.is_literal(),
        Step::Element(row, col) => !row.is_literal() || !col.is_literal(),
    })
}

/// Returns true if an expression may fault: by integers or indices.
fn may_fault(expr: &Expr) -> bool {
    struct Faults(bool);
    impl Visit for Faults {
        fn expr(&mut self, expr: &Expr) {
            let counts = match &expr.kind {
                ExprKind::Binary(..) | ExprKind::Unary(..) => expr.ty.as_int().is_some(),
                ExprKind::Intrinsic(op, _) => {
                    matches!(op, bessemer_ir::Intrinsic::Clamp)
                        || matches!(expr.ty, Type::Scalar(bessemer_ir::Scalar::Int(_)))
                }
                ExprKind::Load(place) => place_may_fault(place),
                _ => false,
            };
            self.0 |= counts;
            visit::walk_expr(self, expr);
        }
    }
    let mut faults = Faults(false);
    faults.expr(expr);
    faults.0
}
