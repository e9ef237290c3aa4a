//! Mentions of a variable in statements of the C tree.
//!
//! Must not know: why somebody looks for them.

use super::tree::{Expr, Init, Step, Stmt, StmtKind};

/// Returns true if a variable of this name is read or written.
pub fn names(body: &[Stmt], name: &str) -> bool {
    body.iter().any(|stmt| {
        let written = match &stmt.kind {
            StmtKind::Assign(place, ..) | StmtKind::Build(place, ..) => place.mentions(name),
            _ => 0,
        };
        written + of_statement(&stmt.kind, name) > 0
            || stmt.kind.blocks().into_iter().any(|block| names(block, name))
    })
}

/// Returns the number of reads of the variable; a write to it, or to a part of it, is none.
pub fn reads(body: &[Stmt], name: &str) -> usize {
    let inner_reads = |stmt: &Stmt| -> usize {
        stmt.kind.blocks().into_iter().map(|block| reads(block, name)).sum()
    };
    body.iter().map(|stmt| of_statement(&stmt.kind, name) + inner_reads(stmt)).sum()
}

/// Returns the number of reads in a statement, without its blocks.
fn of_statement(kind: &StmtKind, name: &str) -> usize {
    let of = |expr: &Expr| expr.mentions(name);
    match kind {
        StmtKind::Declare(_, Some(init)) => of_init(init, name),
        StmtKind::Expr(value) | StmtKind::Return(Some(value)) => of(value),
        StmtKind::Assign(place, _, value) => of_written(place, name) + of(value),
        StmtKind::Build(place, _, init) => of_written(place, name) + of_init(init, name),
        StmtKind::If { condition, .. } | StmtKind::While { condition, .. } => of(condition),
        StmtKind::Switch { scrutinee, .. } => of(scrutinee),
        StmtKind::For { init: (_, first), condition, step, .. } => {
            let step = match step {
                Some(Step::Expr(value)) => of(value),
                Some(Step::Assign(place, value)) => of_written(place, name) + of(value),
                None => 0,
            };
            of(first) + of(condition) + step
        }
        _ => 0,
    }
}

/// Returns the number of reads in the indices and pointers of a written place.
fn of_written(place: &Expr, name: &str) -> usize {
    match place {
        Expr::Name(_) => 0,
        Expr::Member(of, _) => of_written(of, name),
        Expr::Index(of, index) => of_written(of, name) + index.mentions(name),
        _ => place.mentions(name),
    }
}

fn of_init(init: &Init, name: &str) -> usize {
    match init {
        Init::Value(value) => value.mentions(name),
        Init::List { items, .. } => items.iter().map(|(_, item)| of_init(item, name)).sum(),
    }
}
