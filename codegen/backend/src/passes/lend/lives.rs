//! Lifetimes of temporaries, and their overlaps.
//!
//! Statements are numbered in textual order. A temporary lives from the first statement that mentions it to the last.
//! If a loop is between its declaration and a mention, it lives through the whole loop: it may carry a value between
//! passes, and C reads the bounds of a loop in each pass. Memory for a call lives in the call's statement. So two
//! lives without a common statement are never alive together, on any path.

use std::collections::BTreeMap;

use bessemer_ir::visit::{self, Access, Visit, Walk as _};
use bessemer_ir::{Expr, ExprKind, Function, FunctionId, LocalId, Place, Stmt, StmtKind};

use super::row::{Need, Row};

/// Values that need memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// A large local.
    Local(LocalId),
    /// A row that a call needs.
    Call {
        /// Index of the call in the function, in order of evaluation.
        call: usize,
        /// Callee.
        callee: FunctionId,
        /// Index of its row.
        row: usize,
    },
}

/// A temporary and its lifetime.
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

    /// Returns true if both are alive in some statement. Memory for different calls never is.
    pub fn meets(&self, other: &Life) -> bool {
        match (self.what, other.what) {
            (What::Call { call: one, .. }, What::Call { call: other, .. }) => one == other,
            _ => self.first <= other.last && other.first <= self.last,
        }
    }
}

/// A loop around the present statement.
struct Loop {
    first: usize,
    mentioned: Vec<LocalId>,
}

struct Walk<'n> {
    /// Index of the statement.
    at: usize,
    /// Position of each local's declaration.
    declared: Vec<usize>,
    /// First and last statement that mentions each local.
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

    /// Records the use of a place, and of the place of which its root is an alias.
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
