//! Puts a value and the temporaries before it together into one expression.
//!
//! Invariant: the time is linear in the statements and the value; other locals of the function cost nothing.
//!
//! Must not know: what the value is for.

use std::collections::{HashMap, HashSet};

use bessemer_ir::visit::{Access, Visit, VisitMut, walk_place, walk_place_mut};
use bessemer_ir::{Block, Expr, Local, LocalId, Module, Place, Stmt, StmtKind};

use super::decide::decided;
use super::{checks, put};

/// Returns a value into which [`fuse`](super::fuse) has substituted all the statements before it; none if a statement stays.
///
/// Precondition: nothing else uses the locals that the statements declare.
pub(crate) fn alone(
    module: &Module,
    locals: &[Local],
    made: &HashSet<LocalId>,
    stmts: &[Stmt],
    value: &Expr,
) -> Option<Expr> {
    if !stmts.iter().all(|stmt| may_go(stmt, made)) {
        return None;
    }
    let last = Stmt::new(StmtKind::Expr(value.clone()), value.span);
    let mut body = Block(stmts.iter().cloned().chain([last]).collect());
    let mut dense = Dense::default();
    dense.block(&body);
    let known: Vec<Local> = dense.order.iter().map(|local| locals[local.index()].clone()).collect();
    let made = dense.order.iter().enumerate().filter(|(_, local)| made.contains(local));
    let made = made.map(|(at, _)| LocalId(at as u32)).collect();
    Renamed(|local| dense.numbers[&local]).block(&mut body);
    let decided = decided(module, &known, &made, &body);
    put::put(&mut body, &decided, false);
    let [Stmt { kind: StmtKind::Expr(value), .. }] = body.0.as_mut_slice() else { return None };
    Renamed(|local: LocalId| dense.order[local.index()]).expr(value);
    Some(value.clone())
}

/// Returns true if a statement only declares a temporary, or checks an index.
pub(crate) fn may_go(stmt: &Stmt, made: &HashSet<LocalId>) -> bool {
    match &stmt.kind {
        StmtKind::Let { local, value: Some(_) } => made.contains(local),
        kind => checks::index_check(kind).is_some(),
    }
}

/// Numbers the locals of a fragment.
#[derive(Default)]
struct Dense {
    order: Vec<LocalId>,
    numbers: HashMap<LocalId, LocalId>,
}

impl Dense {
    fn note(&mut self, local: LocalId) {
        let next = LocalId(self.order.len() as u32);
        if *self.numbers.entry(local).or_insert(next) == next {
            self.order.push(local);
        }
    }
}

impl Visit for Dense {
    fn place(&mut self, place: &Place, _: Access) {
        self.note(place.root);
        walk_place(self, place);
    }

    fn declaration(&mut self, local: &LocalId) {
        self.note(*local);
    }
}

/// Replaces the handles of locals.
struct Renamed<F>(F);

impl<F: Fn(LocalId) -> LocalId> VisitMut for Renamed<F> {
    fn place(&mut self, place: &mut Place, _: Access) {
        place.root = (self.0)(place.root);
        walk_place_mut(self, place);
    }

    fn declaration(&mut self, local: &mut LocalId) {
        *local = (self.0)(*local);
    }
}
