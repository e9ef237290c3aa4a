//! Moves declarations to the first assignment.
//!
//! A block as a value, `let x = { … }`, is lowered to a declaration, the block's statements, and an assignment. If no
//! statement before the assignment mentions the local, the assignment declares it.
//!
//! Preserves: every statement, the order, and the values of locals. Must not know: faults, calls, types.

use bessemer_ir::visit::{self, VisitMut};
use bessemer_ir::{Block, Function, Stmt, StmtKind};

use bessemer_ir::effects::mentions;

/// Moves the declarations of a function.
pub(super) fn late(function: &mut Function) {
    Late.block(&mut function.body);
}

struct Late;

impl VisitMut for Late {
    fn block(&mut self, block: &mut Block) {
        let mut at = 0;
        while at < block.0.len() {
            at += usize::from(!moved(&mut block.0, at));
        }
        visit::walk_block_mut(self, block);
    }
}

/// Moves the declaration at `at`, if it is one that can be moved.
fn moved(stmts: &mut Vec<Stmt>, at: usize) -> bool {
    let StmtKind::Let { local, value: None } = stmts[at].kind else { return false };
    let next = stmts[at + 1..].iter().position(|stmt| mentions(stmt, local));
    let Some(next) = next.map(|next| at + 1 + next) else { return false };
    let StmtKind::Assign { place, value } = &stmts[next].kind else { return false };
    if place.root != local || !place.steps.is_empty() || mentions(value, local) {
        return false;
    }
    let value = Some(value.clone());
    stmts[next].kind = StmtKind::Let { local, value };
    // The author's comment on the declaration goes before the statements that compute its value.
    let mut comments = stmts.remove(at).comments;
    comments.append(&mut stmts[at].comments);
    stmts[at].comments = comments;
    true
}
