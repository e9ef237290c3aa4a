//! Statements behind a `return`, `break` or `continue`, which nothing reaches (MISRA C:2012, rule 2.1). They come about where
//! the sizes of an instance or the length of a slice decide a condition. Must not know: why a statement leaves.

use bessemer_ir::visit::{VisitMut, walk_block_mut};
use bessemer_ir::{Block, Stmt, StmtKind};

/// Takes what nothing reaches out of a body.
pub(super) fn leave_out(body: &mut Block) {
    Unreached.block(body);
}

struct Unreached;

impl VisitMut for Unreached {
    fn block(&mut self, block: &mut Block) {
        walk_block_mut(self, block);
        if let Some(last) = block.0.iter().position(leaves) {
            block.0.truncate(last + 1);
        }
    }
}

/// Whether control leaves the block by this statement, whatever the input; the blocks in it have lost what nothing reaches.
fn leaves(stmt: &Stmt) -> bool {
    let left = |block: &Block| block.0.last().is_some_and(leaves);
    match &stmt.kind {
        StmtKind::Return(_) | StmtKind::Break | StmtKind::Continue => true,
        StmtKind::If { then, otherwise, .. } => left(then) && left(otherwise),
        StmtKind::Match { arms, otherwise, .. } => {
            arms.iter().all(|arm| left(&arm.body)) && otherwise.as_ref().is_some_and(left)
        }
        _ => false,
    }
}
