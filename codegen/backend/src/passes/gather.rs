//! Moves statements over the elements of vectors next to each other, where the C computes them in one loop.
//!
//! A statement moves up, beyond assignments of single numbers, to the statements that it joins ([`joined`](crate::joined)). The
//! largest magnitude in such an assignment becomes a statement of its own first:
//!
//! ```text
//! let slack = x.sup(low);                          let slack = x.sup(low);
//! worst = max(worst, x.sub(slack).amax());         let largest = x.sub(slack).amax();
//! kept = slack;                                    kept = slack;
//!                                                  worst = max(worst, largest);
//! ```
//!
//! Preserves: every value and every write. A statement moves only beyond statements without calls, checks and
//! branches that neither write what it reads or writes, nor read what it writes. Statements with an author's comment stay in
//! place. Must not know: the C.

use bessemer_ir::effects::{overlap, whole, writes};
use bessemer_ir::visit::{VisitMut, Walk as _, walk_block_mut};
use bessemer_ir::{
    Block, Expr, ExprKind, Fault, Function, Local, LocalId, Mode, Module, Place, Routine, Stmt,
    StmtKind,
};

use crate::joined::{Group, Member, is_separate};

/// Largest number of statements beyond which one moves.
const BEYOND: usize = 8;

/// Gathers the statements of a function; returns true if one moved.
pub(super) fn gather(module: &Module, function: &mut Function) -> bool {
    let mut body = std::mem::take(&mut function.body);
    let mut gather = Gather { module, function, moved: false, any: false };
    gather.block(&mut body);
    let moved = gather.any;
    function.body = body;
    moved
}

struct Gather<'f> {
    module: &'f Module,
    function: &'f mut Function,
    /// True if a statement of the present block moved.
    moved: bool,
    /// True if one of any block did.
    any: bool,
}

impl VisitMut for Gather<'_> {
    fn block(&mut self, block: &mut Block) {
        walk_block_mut(self, block);
        // A statement that moved may let others join.
        self.moved = true;
        while std::mem::take(&mut self.moved) {
            let mut at = 0;
            while at < block.0.len() {
                at = match self.member(&block.0[at]).and_then(Group::new) {
                    Some(group) => self.group(&mut block.0, at + 1, group),
                    None => at + 1,
                };
            }
            self.any |= self.moved;
        }
    }
}

impl Gather<'_> {
    fn member(&self, stmt: &Stmt) -> Option<Member> {
        Member::of(self.module, self.function, stmt)
    }

    /// Moves statements to a group that ends at `end`; returns its new end.
    fn group(&mut self, stmts: &mut Vec<Stmt>, mut end: usize, mut group: Group) -> usize {
        let mut at = end;
        while at < stmts.len()
            && stmts[end..at].iter().filter(|it| !is_proved(it)).count() <= BEYOND
        {
            let stays = at > end && !stmts[at].comments.is_empty();
            if let Some(member) = self.member(&stmts[at])
                && group.accepts(&member)
                && !stays
                && moves_beyond(&stmts[at], &stmts[end..at])
            {
                self.moved |= at > end;
                let stmt = stmts.remove(at);
                stmts.insert(end, stmt);
                group.push(member);
                (end, at) = (end + 1, at + 1);
                continue;
            }
            if !self.is_passed(&stmts[at]) {
                break;
            }
            if let Some((magnitude, member)) = self.magnitude(&stmts[at])
                && group.accepts(&member)
                && moves_beyond(&magnitude, &stmts[end..at])
            {
                self.moved = true;
                self.declare(&magnitude, &mut stmts[at]);
                stmts.insert(end, magnitude);
                group.push(member);
                (end, at) = (end + 1, at + 1);
                continue;
            }
            at += 1;
        }
        end
    }

    /// Returns true if a statement only stores a number, or is a check that never fails.
    fn is_passed(&self, stmt: &Stmt) -> bool {
        let is_number = match &stmt.kind {
            StmtKind::Let { value: Some(value), .. } | StmtKind::Assign { value, .. } => {
                value.ty.is_word()
            }
            _ => is_proved(stmt),
        };
        let calls = |expr: &Expr| matches!(expr.kind, ExprKind::Call(..));
        is_number && !stmt.any_expr(calls) && is_separate(self.module, self.function, stmt)
    }

    /// Returns the first largest magnitude in a number as a statement of its own; none if a condition decides about it.
    fn magnitude(&self, stmt: &Stmt) -> Option<(Stmt, Member)> {
        let is_decided = |expr: &Expr| matches!(expr.kind, ExprKind::Logic(..));
        let whole = match &stmt.kind {
            StmtKind::Let { value: Some(value), .. } | StmtKind::Assign { value, .. } => value,
            _ => return None,
        };
        let is_alone = is_magnitude(whole) && matches!(stmt.kind, StmtKind::Let { .. });
        if is_alone || whole.any_expr(is_decided) {
            return None;
        }
        let mut found = None;
        whole.each_expr(|expr| {
            if is_magnitude(expr) && found.is_none() {
                found = Some(expr.clone());
            }
        });
        let local = LocalId(u32::try_from(self.function.locals.len()).ok()?);
        let kind = StmtKind::Let { local, value: Some(found?) };
        let magnitude = Stmt { kind, span: stmt.span, comments: Vec::new() };
        let member = self.member(&magnitude)?;
        Some((magnitude, member))
    }

    /// Adds the local of a magnitude, and reads it in the statement that computed it.
    fn declare(&mut self, magnitude: &Stmt, stmt: &mut Stmt) {
        let StmtKind::Let { local, value: Some(value) } = &magnitude.kind else { return };
        let (name, ty, span) = ("largest".to_owned(), value.ty.clone(), value.span);
        self.function.locals.push(Local { name, ty, mode: Mode::Value, span });
        Put { local: *local, done: false }.stmt(stmt);
    }
}

/// Returns true for a check that is left out.
fn is_proved(stmt: &Stmt) -> bool {
    matches!(stmt.kind, StmtKind::Check { fault: Fault::LeftOut, .. })
}

fn is_magnitude(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Routine(Routine::Amax, _))
}

/// Visitor that replaces the first largest magnitude by a local.
struct Put {
    local: LocalId,
    done: bool,
}

impl VisitMut for Put {
    fn expr(&mut self, expr: &mut Expr) {
        if self.done {
            return;
        }
        if is_magnitude(expr) {
            self.done = true;
            let place = Place { ty: expr.ty.clone(), span: expr.span, ..whole(self.local) };
            expr.kind = ExprKind::Load(place);
            return;
        }
        bessemer_ir::visit::walk_expr_mut(self, expr);
    }
}

/// Returns true if a statement may run before others: none writes what it uses, and it writes nothing that one uses.
fn moves_beyond(stmt: &Stmt, others: &[Stmt]) -> bool {
    let written = writes([stmt]);
    let meets = |stmt: &Stmt, written: &[Place]| {
        stmt.any_place(|place, _| written.iter().any(|written| overlap(written, place)))
    };
    !others.iter().any(|other| meets(other, &written) || meets(stmt, &writes([other])))
}
