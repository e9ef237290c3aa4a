//! Replaces loops with exactly one pass by their statements.
//!
//! Invariant: the statements after a `break` in the loop run in the same cases without it.
//!
//! Must not know: the loop's source.

use bessemer_ir::{Block, Stmt, StmtKind};

/// Returns the statements of a pass that leaves its loop at its end, without the loop. None if anything but an `if … {
/// …; break; }` leaves it before.
pub(super) fn single_pass(pass: &[Stmt]) -> Option<Block> {
    without_breaks(&without_last(pass)?)
}

/// Removes the `break` at the end of each path; none if a path ends otherwise.
fn without_last(pass: &[Stmt]) -> Option<Vec<Stmt>> {
    let (last, rest) = pass.split_last()?;
    let mut all = rest.to_vec();
    match &last.kind {
        StmtKind::Break => {}
        StmtKind::If { condition, then, otherwise } => {
            let [then, otherwise] = [without_last(&then.0)?, without_last(&otherwise.0)?];
            let condition = condition.clone();
            let (condition, then, otherwise) = match then.is_empty() {
                true => (condition.negated(), otherwise, then),
                false => (condition, then, otherwise),
            };
            let (then, otherwise) = (Block(then), Block(otherwise));
            let kind = StmtKind::If { condition, then, otherwise };
            all.extend([Stmt { kind, ..last.clone() }]);
        }
        _ => return None,
    }
    Some(all)
}

/// Moves statements after an `if … { …; break; }` into its `else`.
fn without_breaks(stmts: &[Stmt]) -> Option<Block> {
    let leaves = |kind: &StmtKind| matches!(kind, StmtKind::Break | StmtKind::Continue);
    let remains = |stmts: &[Stmt]| !stmts.iter().any(|stmt| stmt.any_branch(&leaves));
    let Some(at) = stmts.iter().position(|stmt| stmt.any_branch(&leaves)) else {
        return Some(Block(stmts.to_vec()));
    };
    let StmtKind::If { condition, then, otherwise } = &stmts[at].kind else { return None };
    let (Stmt { kind: StmtKind::Break, .. }, then) = then.0.split_last()? else { return None };
    if !remains(then) || !remains(&otherwise.0) {
        return None;
    }
    let (condition, then) = (condition.clone(), Block(then.to_vec()));
    let mut otherwise = otherwise.clone();
    otherwise.0.extend(without_breaks(&stmts[at + 1..])?.0);
    let (condition, then, otherwise) = match then.0.is_empty() {
        true => (condition.negated(), otherwise, then),
        false => (condition, then, otherwise),
    };
    let mut all = stmts[..at].to_vec();
    let branches = (!then.0.is_empty()).then_some(StmtKind::If { condition, then, otherwise });
    all.extend(branches.map(|kind| Stmt::new(kind, stmts[at].span)));
    Some(Block(all))
}
