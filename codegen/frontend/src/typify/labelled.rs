//! Labelled blocks, which may be left early.
//!
//! Must not know: how the exits become branches ([`marks`](super::marks)).

use bessemer_ir::tree;
use bessemer_ir::visit::Walk;
use bessemer_ir::{Block, Expr, Span, Stmt, StmtKind, Type};

use super::Result;
use super::frames::{Frame, Target};
use super::lowering::Lowering;
use super::marks::{Leaving, branches_mut};
use bessemer_ir::effects;

impl Lowering<'_, '_> {
    /// Lowers `'label: { … }`, and assigns the value of each `break` and of its end to `target` if there is one.
    pub(super) fn labelled(
        &mut self,
        label: &str,
        body: &tree::Block,
        target: Option<&Target>,
        expr: &tree::Expr,
    ) -> Result<()> {
        let (frame, span) = (Frame::of(Some(label), target), self.span(expr.site));
        self.left(label, frame, span, |inner| inner.block(body, target))
    }

    /// Lowers a block that may be left early; `name` names the flag that records it.
    pub(super) fn left(
        &mut self,
        name: &str,
        frame: Frame,
        span: Span,
        lower: impl FnOnce(&mut Self) -> Result<Block>,
    ) -> Result<()> {
        let target = frame.target.clone();
        let mark = self.local(format!("{name}_done"), Type::BOOL, span);
        self.frames.enter(Frame { mark: Some(mark), ..frame });
        let lowered = lower(self);
        let marks = self.frames.marks();
        self.frames.end();
        let lowered = lowered?;
        let flagged = effects::writes_local(&lowered, mark);
        let mut leaving = Leaving { mark, marks, flagged };
        let Block(stmts) = leaving.without_marks(lowered, false);
        if leaving.flagged {
            let no = Expr::bool(false, span);
            self.emit(StmtKind::Let { local: mark, value: Some(no) }, span);
            // Behind a flag no compiler sees that something has been assigned.
            stmts.each_stmt(|stmt| {
                if let StmtKind::Let { local, value: None } = &stmt.kind {
                    self.locals.note_valued(*local);
                }
            });
            if let Some(Target::Place(place)) = target {
                self.locals.note_valued(place.root);
            }
        }
        self.out.extend(stmts);
        Ok(())
    }

    /// Adds initial values to the declarations of locals that need one.
    pub(super) fn give_values(&self, stmts: &mut [Stmt]) {
        for stmt in stmts {
            if let StmtKind::Let { local, value: value @ None } = &mut stmt.kind
                && self.locals.is_valued(*local)
            {
                *value = Some(self.zero(&self.locals[local.index()].ty, stmt.span));
            }
            if let StmtKind::For { body, .. } = &mut stmt.kind {
                self.give_values(&mut body.0);
            }
            branches_mut(stmt).into_iter().for_each(|block| self.give_values(&mut block.0));
        }
    }
}
