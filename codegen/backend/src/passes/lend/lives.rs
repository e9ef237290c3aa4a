//! Lifetimes of temporaries, and their overlap.
//!
//! Statements are counted in the order in which they stand. A temporary lives from the first that mentions it to
//! the last, and through the whole of each loop that stands between its declaration and a mention: it may carry
//! something from one pass to the next, and C reads the bounds of a loop in each pass. What a call is lent lives in the statement of the call. So two lives that
//! meet in no statement are never alive together, whatever path is run.

use std::collections::BTreeMap;

use bessemer_ir::visit::{self, Access, Visit, Walk as _};
use bessemer_ir::{Expr, ExprKind, Function, FunctionId, LocalId, Place, Stmt, StmtKind};

use super::row::{Need, Row};

/// The values that need memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// A large local.
    Local(LocalId),
    /// A row that a call is lent.
    Call {
        /// Index of the call in the function, in order of evaluation.
        call: usize,
        /// Callee.
        callee: FunctionId,
        /// Index of its row.
        row: usize,
    },
}

/// A temporary, and when it is alive.
#[derive(Clone, Debug)]
pub(super) struct Life {
    pub what: What,
    pub row: Row,
    first: usize,
    last: usize,
}

impl Life {
    /// Returns the lifetimes of a function's large locals, then of its calls. `flat`: matrices are arrays of scalars.
    /// `names` are locals that become names for other memory in C.
    pub fn of(
        function: &Function,
        large: &[LocalId],
        names: &BTreeMap<LocalId, Place>,
        needs: &[Need],
        flat: bool,
    ) -> Vec<Life> {
        let count = function.locals.len();
        let mut walk = Walk {
            at: 0,
            declared: vec![0; count],
            seen: vec![None; count],
            loops: Vec::new(),
            calls: Vec::new(),
            call: 0,
            names,
            needs,
        };
        walk.block(&function.body);
        let local = |id: &LocalId| {
            let (first, last) = walk.seen[id.index()]?;
            let row = Row::of(&function.local(*id).ty, flat);
            Some(Life { what: What::Local(*id), row, first, last })
        };
        large.iter().filter_map(local).chain(walk.calls).collect()
    }

    /// Returns true if both are alive in some statement. What different calls are lent never is.
    pub fn meets(&self, other: &Life) -> bool {
        match (self.what, other.what) {
            (What::Call { call: one, .. }, What::Call { call: other, .. }) => one == other,
            _ => self.first <= other.last && other.first <= self.last,
        }
    }
}

/// A loop around what is being looked at.
struct Loop {
    first: usize,
    mentioned: Vec<LocalId>,
}

struct Walk<'n> {
    /// The statement.
    at: usize,
    /// Position of each local's declaration.
    declared: Vec<usize>,
    /// The first statement that mentions it, and the last.
    seen: Vec<Option<(usize, usize)>>,
    loops: Vec<Loop>,
    calls: Vec<Life>,
    /// Number of calls so far.
    call: usize,
    names: &'n BTreeMap<LocalId, Place>,
    needs: &'n [Need],
}

impl Walk<'_> {
    fn mention(&mut self, local: LocalId) {
        self.extend(local, self.at, self.at);
        if let Some(inner) = self.loops.last_mut() {
            inner.mentioned.push(local);
        }
    }

    /// A place is read or written; what its root is a name for is, too.
    fn named(&mut self, place: &Place) {
        self.mention(place.root);
        if let Some(of) = self.names.get(&place.root) {
            self.mention(of.root);
        }
    }

    fn extend(&mut self, local: LocalId, from: usize, to: usize) {
        let seen = &mut self.seen[local.index()];
        *seen = Some(seen.map_or((from, to), |(first, last)| (first.min(from), last.max(to))));
    }
}

impl Visit for Walk<'_> {
    fn stmt(&mut self, stmt: &Stmt) {
        self.at += 1;
        let StmtKind::For { variable, from, to, body, .. } = &stmt.kind else {
            visit::walk_stmt(self, stmt);
            // Without a first value it holds nothing yet.
            if let StmtKind::Let { local, value: Some(_) } = &stmt.kind {
                self.mention(*local);
            }
            return;
        };
        self.expr(from);
        self.expr(to);
        self.declaration(variable);
        self.loops.push(Loop { first: self.at + 1, mentioned: Vec::new() });
        self.block(body);
        [from, to].into_iter().for_each(|bound| bound.each_place(|place, _| self.named(place)));
        let Some(Loop { first, mentioned }) = self.loops.pop() else { return };
        for local in mentioned {
            if self.declared[local.index()] < first {
                self.extend(local, first, self.at);
                if let Some(outer) = self.loops.last_mut() {
                    outer.mentioned.push(local);
                }
            }
        }
    }

    fn declaration(&mut self, local: &LocalId) {
        self.declared[local.index()] = self.at;
    }

    fn expr(&mut self, expr: &Expr) {
        visit::walk_expr(self, expr);
        if let ExprKind::Call(callee, _) = &expr.kind {
            for (index, row) in self.needs[callee.index()].iter().enumerate() {
                let what = What::Call { call: self.call, callee: *callee, row: index };
                self.calls.push(Life { what, row: row.clone(), first: self.at, last: self.at });
            }
            self.call += 1;
        }
    }

    fn place(&mut self, place: &Place, _: Access) {
        self.named(place);
        visit::walk_place(self, place);
    }
}
