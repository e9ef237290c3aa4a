//! Arrays and matrices that a loop fills: the value that they start with is never seen, so C goes without.
//!
//! Invariant: where [`filled`] says so, every element is assigned before anything reads it, on each path.

use bessemer_ir::visit::Walk;
use bessemer_ir::{Block, Expr, ExprKind, LocalId, Place, Step, Stmt, StmtKind, Type};

use crate::effects::mentions;

/// Whether a loop of `rest`, the first statement that mentions `local`, assigns each of its elements.
pub(super) fn filled(local: LocalId, ty: &Type, rest: &[Stmt]) -> bool {
    let Some(first) = rest.iter().find(|stmt| mentions(*stmt, local)) else {
        return false;
    };
    let Some((outer, to, body)) = through(first) else { return false };
    if let ([inner], Type::Matrix { rows, cols, .. }) = (body.0.as_slice(), ty)
        && let Some((row, last, body)) = through(inner)
    {
        // By columns, or by rows.
        let (inner, outer) = (Some(row), Some(outer));
        return (to, last) == (*cols, *rows) && assigns(local, &[inner, outer], body)
            || (to, last) == (*rows, *cols) && assigns(local, &[outer, inner], body);
    }
    let (count, element) = match *ty {
        Type::Array { len, .. } => (len, vec![Some(outer)]),
        Type::Matrix { rows, cols: 1, .. } => (rows, vec![Some(outer), None]),
        Type::Matrix { rows: 1, cols, .. } => (cols, vec![None, Some(outer)]),
        Type::Matrix { rows, cols, .. } => (rows * cols, vec![Some(outer)]),
        _ => return false,
    };
    to == count && assigns(local, &element, body)
}

/// The counter of a loop from 0, its end and its body.
fn through(stmt: &Stmt) -> Option<(LocalId, u32, &Block)> {
    match &stmt.kind {
        StmtKind::For { variable, from, to, inclusive: false, body, .. } => {
            match (&from.kind, &to.kind) {
                (ExprKind::Literal(0), ExprKind::Literal(to)) => {
                    Some((*variable, u32::try_from(*to).ok()?, body))
                }
                _ => None,
            }
        }
        _ => None,
    }
}

/// Whether each path through a block assigns the element at these counters (none: at 0), before anything
/// else of the local is touched.
fn assigns(local: LocalId, at: &[Option<LocalId>], block: &Block) -> bool {
    for stmt in &block.0 {
        match &stmt.kind {
            StmtKind::Assign { place, value } if place.root == local => {
                return is_element(place, at) && !mentions(value, local);
            }
            StmtKind::If { condition, then, otherwise } => {
                let both = assigns(local, at, then) && assigns(local, at, otherwise);
                if both {
                    return !mentions(condition, local);
                }
            }
            StmtKind::Break | StmtKind::Continue | StmtKind::Return(_) => return false,
            _ => {}
        }
        if mentions(stmt, local) || leaves(stmt) {
            return false;
        }
    }
    false
}

fn is_element(place: &Place, at: &[Option<LocalId>]) -> bool {
    let is = |index: &Expr, at: &Option<LocalId>| match (&index.kind, at) {
        (ExprKind::Load(place), Some(counter)) => place.root == *counter && place.steps.is_empty(),
        (ExprKind::Literal(word), None) => *word == 0,
        _ => false,
    };
    match (place.steps.as_slice(), at) {
        ([Step::Index(index)], [counter]) => is(index, counter),
        ([Step::Element(row, column)], [first, second]) => is(row, first) && is(column, second),
        _ => false,
    }
}

/// Whether something in a statement leaves a loop or the function.
fn leaves(stmt: &Stmt) -> bool {
    stmt.any_stmt(|stmt| {
        matches!(stmt.kind, StmtKind::Break | StmtKind::Continue | StmtKind::Return(_))
    })
}
