//! Facts about temporaries that the backward walk needs before it reaches their declarations.
//!
//! Must not know: what makes a temporary go.

use std::collections::HashSet;

use bessemer_ir::visit::{Access, Visit, walk_block, walk_expr, walk_place, walk_stmt};
use bessemer_ir::{Block, Expr, Local, LocalId, Module, Place, Stmt, StmtKind};

use super::checks::{Counters, Index, count, doubtful, index_check};

/// Counts uses, parts, widths, loops and checks of temporaries.
pub(super) struct Known<'f> {
    module: &'f Module,
    locals: &'f [Local],
    /// Marks the locals that `fuse` may substitute: temporaries of the compiler, declared with a value, and only
    /// read.
    pub may_go: Vec<bool>,
    /// Counts uses without those in checks of indices, which may be removed.
    pub uses: Vec<u32>,
    /// Marks the locals that are declared or used.
    pub mentioned: Vec<bool>,
    /// Marks the locals that nothing writes.
    constant: Vec<bool>,
    /// Marks the locals of which single parts are read.
    pub parts: Vec<bool>,
    /// Upper bound of the evaluation steps of each value, including the values of temporaries that only it reads.
    width: Vec<u64>,
    /// Number of loops around the declaration.
    pub depth: Vec<usize>,
    loops: usize,
    steps: u64,
    checks: Checks,
    pub counters: Counters,
}

/// Checks of indices.
#[derive(Default)]
struct Checks {
    in_check: bool,
    /// Indices checked so far in the enclosing blocks, in `order` of their checks.
    checked: HashSet<Index>,
    order: Vec<Index>,
    /// Index of each check that repeats an earlier check of the index, or that a counter always passes.
    again: Vec<Option<Index>>,
    /// Indices that any check names.
    asserted: HashSet<Index>,
    /// Indices with a use that no check precedes.
    unchecked: HashSet<Index>,
}

impl<'f> Known<'f> {
    pub fn new(module: &'f Module, locals: &'f [Local], may_go: Vec<bool>) -> Self {
        let count = may_go.len();
        Known {
            module,
            locals,
            may_go,
            uses: vec![0; count],
            mentioned: vec![false; count],
            constant: vec![true; count],
            parts: vec![false; count],
            width: vec![0; count],
            depth: vec![0; count],
            loops: 0,
            steps: 0,
            checks: Checks::default(),
            counters: Counters::new(),
        }
    }

    /// Returns the number of evaluation steps that a use of a temporary adds: its width if this is the only use, else
    /// 0.
    pub fn room(&self, local: LocalId) -> u64 {
        if self.uses[local.index()] == 1 { self.width[local.index()] } else { 0 }
    }

    /// Removes the last check from the list; returns true if it is redundant.
    pub fn is_last_again(&mut self) -> bool {
        self.checks.again.pop().flatten().is_some_and(|it| self.constant[it.0.index()])
    }

    /// Returns true if a check precedes each use of these indices.
    pub fn are_checked(&self, indices: &[Option<Index>]) -> bool {
        let is_checked = |it: &Index| {
            self.constant[it.0.index()]
                && self.checks.asserted.contains(it)
                && !self.checks.unchecked.contains(it)
        };
        indices.iter().all(|it| it.as_ref().is_some_and(is_checked))
    }
}

impl Visit for Known<'_> {
    fn block(&mut self, block: &Block) {
        let around = self.checks.order.len();
        walk_block(self, block);
        for index in self.checks.order.drain(around..) {
            self.checks.checked.remove(&index);
        }
    }

    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                self.depth[local.index()] = self.loops;
                self.steps = 0;
                walk_stmt(self, stmt);
                self.width[local.index()] = self.steps;
                self.may_go[local.index()] &= value.is_some();
                self.mentioned[local.index()] = true;
                self.constant[local.index()] &= value.is_some();
            }
            kind @ StmtKind::For { .. } => {
                count(&mut self.counters, kind);
                self.loops += 1;
                walk_stmt(self, stmt);
                self.loops -= 1;
            }
            kind => {
                let check = index_check(kind);
                self.checks.in_check = check.is_some();
                walk_stmt(self, stmt);
                self.checks.in_check = false;
                if let StmtKind::Check { .. } = kind {
                    let holds = |(index, len): &Index| {
                        self.counters.get(index).is_some_and(|above| *above <= u64::from(*len))
                    };
                    let holds = |it: &Index| self.checks.checked.contains(it) || holds(it);
                    self.checks.again.push(check.filter(holds));
                }
                let new = check.filter(|it| self.checks.checked.insert(*it));
                self.checks.order.extend(new);
                self.checks.asserted.extend(check);
            }
        }
    }

    fn expr(&mut self, expr: &Expr) {
        self.steps += 2;
        walk_expr(self, expr);
    }

    fn place(&mut self, place: &Place, access: Access) {
        let at = place.root.index();
        self.mentioned[at] = true;
        self.uses[at] += u32::from(!self.checks.in_check);
        self.steps += 4 + self.room(place.root);
        self.may_go[at] &= access == Access::Read;
        self.constant[at] &= access == Access::Read;
        let doubtful = doubtful(self.module, self.locals, &self.counters, place)
            .into_iter()
            .flatten()
            .flatten();
        for index in doubtful {
            if !self.checks.checked.contains(&index) {
                self.checks.unchecked.insert(index);
            }
        }
        self.parts[at] |= !place.steps.is_empty();
        walk_place(self, place);
    }
}
