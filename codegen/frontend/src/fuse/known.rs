//! Facts about temporaries that the backward walk needs before it reaches their declarations.
//!
//! Must not know: what makes a temporary go.

use bessemer_ir::visit::{Access, Visit, walk_expr, walk_place, walk_stmt};
use bessemer_ir::{Expr, LocalId, Place, Stmt, StmtKind};

/// Counts uses, parts, widths and loops of temporaries.
pub(super) struct Known {
    /// Marks the locals that `fuse` may substitute: temporaries of the compiler, declared with a value, and only
    /// read.
    pub may_go: Vec<bool>,
    pub uses: Vec<u32>,
    /// Marks the locals of which single parts are read.
    pub parts: Vec<bool>,
    /// Upper bound of the evaluation steps of each value, including the values of temporaries that only it reads.
    width: Vec<u64>,
    /// Number of loops around the declaration.
    pub depth: Vec<usize>,
    loops: usize,
    steps: u64,
}

impl Known {
    pub fn new(may_go: Vec<bool>) -> Known {
        let count = may_go.len();
        Known {
            may_go,
            uses: vec![0; count],
            parts: vec![false; count],
            width: vec![0; count],
            depth: vec![0; count],
            loops: 0,
            steps: 0,
        }
    }

    /// Returns the number of evaluation steps that a use of a temporary adds: its width if this is the only use, else
    /// 0.
    pub fn room(&self, local: LocalId) -> u64 {
        if self.uses[local.index()] == 1 { self.width[local.index()] } else { 0 }
    }
}

impl Visit for Known {
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                self.depth[local.index()] = self.loops;
                self.steps = 0;
                walk_stmt(self, stmt);
                self.width[local.index()] = self.steps;
                self.may_go[local.index()] &= value.is_some();
            }
            StmtKind::For { .. } => {
                self.loops += 1;
                walk_stmt(self, stmt);
                self.loops -= 1;
            }
            _ => walk_stmt(self, stmt),
        }
    }

    fn expr(&mut self, expr: &Expr) {
        self.steps += 2;
        walk_expr(self, expr);
    }

    fn place(&mut self, place: &Place, access: Access) {
        let at = place.root.index();
        self.uses[at] += 1;
        self.steps += 4 + self.room(place.root);
        self.may_go[at] &= access == Access::Read;
        self.parts[at] |= !place.steps.is_empty();
        walk_place(self, place);
    }
}
