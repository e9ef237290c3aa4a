//! Removes what the value and the Jacobians do not need, and makes the names of locals unique in their scopes.

use std::collections::BTreeSet;

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{
    Block, Expr, ExprKind, Function, Local, LocalId, Place, Step, Stmt, StmtKind, Type,
};

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

/// Gives each local a name of Rust that no other local in its scope has. Locals of blocks beside each other may share one.
fn name(function: &mut Function) {
    let parameters = function.locals.iter().take(function.params as usize);
    let used = parameters.map(|it| it.name.clone()).collect();
    name_block(&function.body, &mut function.locals, used);
}

fn name_block(block: &Block, locals: &mut [Local], mut used: BTreeSet<String>) {
    for Stmt { kind, .. } in &block.0 {
        match kind {
            StmtKind::Let { local, .. } => name_local(&mut locals[local.index()], &mut used),
            StmtKind::For { variable, body, .. } => {
                let mut inside = used.clone();
                name_local(&mut locals[variable.index()], &mut inside);
                name_block(body, locals, inside);
            }
            StmtKind::If { then, otherwise, .. } => {
                name_block(then, locals, used.clone());
                name_block(otherwise, locals, used.clone());
            }
            StmtKind::Match { arms, otherwise, .. } => {
                let arms = arms.iter().map(|arm| &arm.body);
                arms.chain(otherwise).for_each(|it| name_block(it, locals, used.clone()));
            }
            _ => {}
        }
    }
}

fn name_local(local: &mut Local, used: &mut BTreeSet<String>) {
    let base = crate::rust::identifier(&local.name);
    let numbered = (2_u32..).map(|count| format!("{base}_{count}"));
    let mut names = std::iter::once(base.clone()).chain(numbered);
    local.name = names.find(|name| used.insert(name.clone())).unwrap_or(base);
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
