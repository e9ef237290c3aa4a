//! Marks of the exits of a block, and their removal. C cannot leave a block, so the statements after a `break` move to the
//! other branch:
//!
//! `'found: { if a { break 'found x; } rest }` becomes `if a { x } else { rest }`. If both branches can reach the
//! following statements, or a loop is left, a flag records that the block was left.
//!
//! Unreachable statements after a `return`, `break` or `continue` (MISRA C:2012, rule 2.1) are removed. They arise
//! where the sizes of an instance or the length of a slice decide a condition.
//!
//! Must not know: the tree. It reads and writes statements of the IR alone.

use bessemer_ir::visit::{VisitMut, walk_block_mut};
use bessemer_ir::{Arm, Block, Expr, LocalId, Place, Span, Stmt, StmtKind, Type};

/// Returns a mark that represents the `break` of a block until the whole block is lowered.
pub(super) fn mark(mark: LocalId) -> StmtKind {
    StmtKind::Let { local: mark, value: None }
}

/// Replaces the marks of one block.
pub(super) struct Leaving {
    pub mark: LocalId,
    /// Marks of all blocks that may be left here, including this one.
    pub marks: Vec<LocalId>,
    /// True if a flag is needed.
    pub flagged: bool,
}

impl Leaving {
    /// Returns the block without its marks. `followed` is true if further statements run unless the flag is set.
    pub(super) fn without_marks(&mut self, block: Block, followed: bool) -> Block {
        let mut done = Vec::new();
        let mut rest = block.0.into_iter();
        while let Some(next) = rest.next() {
            if is_mark(&next.kind, self.mark) {
                if followed {
                    done.push(Stmt { kind: self.raise(next.span), ..next });
                }
                break;
            }
            if !next.any_branch(&|kind| is_mark(kind, self.mark)) {
                done.push(next);
                continue;
            }
            let behind: Vec<Stmt> = rest.collect();
            done.extend(self.branching(next, behind, followed));
            break;
        }
        Block(done)
    }

    /// Moves the statements after a branching statement into the branches that do not leave the block.
    fn branching(&mut self, mut next: Stmt, behind: Vec<Stmt>, followed: bool) -> Vec<Stmt> {
        let marks = &self.marks;
        let mut passing = branches_mut(&mut next);
        passing.retain(|block| falls_through(block, marks));
        let shared = match (passing.len(), behind.is_empty()) {
            (_, true) | (0, _) => None,
            (1, _) => {
                passing.into_iter().for_each(|block| block.0.extend(behind.iter().cloned()));
                None
            }
            _ => Some(behind),
        };
        let span = next.span;
        let told =
            matches!(&next.kind, StmtKind::If { condition, .. } if *condition == self.flag(span));
        for block in branches_mut(&mut next) {
            let followed = followed && !told;
            *block = self.without_marks(std::mem::take(block), followed || shared.is_some());
        }
        let mut done = vec![turned(next)];
        // Nothing comes behind it that the flag could keep from being done.
        if told {
            done.retain(|stmt| stmt.branches().any(|it| !it.0.is_empty()));
        }
        if let Some(behind) = shared {
            self.flagged = true;
            let then = self.without_marks(Block(behind), followed);
            let condition = self.flag(span).negated();
            done.push(Stmt::new(StmtKind::if_then(condition, then), span));
        }
        done
    }

    fn flag(&self, span: Span) -> Expr {
        Expr::local(self.mark, &Type::BOOL, span)
    }

    fn raise(&mut self, span: Span) -> StmtKind {
        self.flagged = true;
        let place = Place::local(self.mark, Type::BOOL, span);
        StmtKind::Assign { place, value: Expr::bool(true, span) }
    }
}

fn is_mark(kind: &StmtKind, mark: LocalId) -> bool {
    matches!(kind, StmtKind::Let { local, value: None } if *local == mark)
}

/// Returns the branches of a statement, mutably.
pub(super) fn branches_mut(stmt: &mut Stmt) -> Vec<&mut Block> {
    match &mut stmt.kind {
        StmtKind::If { then, otherwise, .. } => vec![then, otherwise],
        StmtKind::Match { arms, otherwise, .. } => {
            arms.iter_mut().map(|Arm { body, .. }| body).chain(otherwise).collect()
        }
        _ => Vec::new(),
    }
}

/// Returns true if the end of a block may be reached.
fn falls_through(block: &Block, marks: &[LocalId]) -> bool {
    !block.0.iter().any(|stmt| match &stmt.kind {
        StmtKind::Break | StmtKind::Continue | StmtKind::Return(_) => true,
        StmtKind::If { .. } | StmtKind::Match { .. } => {
            !stmt.branches().any(|block| falls_through(block, marks))
        }
        _ => marks.iter().any(|mark| is_mark(&stmt.kind, *mark)),
    })
}

/// Negates an `if` whose first branch is empty, and swaps its branches.
fn turned(mut stmt: Stmt) -> Stmt {
    if let StmtKind::If { condition, then, otherwise } = &mut stmt.kind
        && then.0.is_empty()
        && !otherwise.0.is_empty()
    {
        *condition = condition.clone().negated();
        std::mem::swap(then, otherwise);
    }
    stmt
}

/// Removes unreachable statements from a body (MISRA C:2012, rule 2.1). They follow a `return`, `break` or `continue`
/// when the sizes of an instance or the length of a slice decide a condition.
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

/// Returns true if control always leaves the block by this statement. Unreachable statements must have been removed
/// from its branches.
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
