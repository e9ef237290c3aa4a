//! Puts a value and the temporaries before it together into one expression.
//!
//! Invariant: the time is linear in the statements and the value; other locals of the function cost nothing.
//!
//! Must not know: what the value is for.

use std::collections::HashMap;

use bessemer_ir::visit::{Access, Visit, VisitMut, walk_place, walk_place_mut};
use bessemer_ir::{Block, Expr, ExprKind, Local, LocalId, Module, Place, Stmt, StmtKind};

use super::decide::decided;
use super::{checks, put};

/// A value, the statements before it, and temporaries that later code reads as names of places.
pub(crate) struct Before<'b> {
    pub stmts: &'b [Stmt],
    pub value: &'b Expr,
    pub copies: &'b [LocalId],
}

/// A value with the temporaries before it substituted.
pub(crate) struct Joined {
    /// The statements that stay.
    pub stmts: Vec<Stmt>,
    pub value: Expr,
    /// The place of each copy that is gone.
    pub places: Vec<Option<Place>>,
}

/// Substitutes the statements before a value into it, as [`fuse`](super::fuse) does: all of them, or, if later code reads
/// copies, those that can be. Returns none if a statement stays and no copy goes.
///
/// Precondition: nothing else uses the locals that the statements declare, but for the copies.
pub(crate) fn joined(
    module: &Module,
    locals: &[Local],
    made: &dyn Fn(LocalId) -> bool,
    before: &Before,
) -> Option<Joined> {
    let Before { stmts, value, copies } = before;
    if copies.is_empty() && !stmts.iter().all(|stmt| may_go(stmt, made)) {
        return None;
    }
    let read = |value: &Expr| Stmt::new(StmtKind::Expr(value.clone()), value.span);
    let later = copies.iter().map(|copy| {
        let local = &locals[copy.index()];
        read(&Expr::local(*copy, &local.ty, local.span))
    });
    let mut body = Block(stmts.iter().cloned().chain([read(value)]).chain(later).collect());
    let mut dense = Dense::default();
    dense.block(&body);
    let known: Vec<Local> = dense.order.iter().map(|local| locals[local.index()].clone()).collect();
    let made = |local: LocalId| made(dense.order[local.index()]);
    let is_copy = |local: LocalId| copies.contains(&dense.order[local.index()]);
    Renamed(|local| dense.numbers[&local]).block(&mut body);
    let decided = decided(module, &known, (&made, &is_copy), &body);
    put::put(&mut body, &decided, false);
    Renamed(|local: LocalId| dense.order[local.index()]).block(&mut body);
    let read = body.0.split_off(body.0.len() - copies.len() - 1);
    let mut read = read.into_iter().filter_map(|stmt| match stmt.kind {
        StmtKind::Expr(value) => Some(value),
        _ => None,
    });
    let value = read.next()?;
    let places = read.zip(copies.iter()).map(|(read, copy)| match read.kind {
        ExprKind::Load(place) => Some(place).filter(|place| place.root != *copy),
        _ => None,
    });
    let places: Vec<_> = places.collect();
    let joined = body.0.is_empty() || places.iter().any(Option::is_some);
    joined.then_some(Joined { stmts: body.0, value, places })
}

/// Returns true if a statement only declares a temporary, or checks an index.
pub(crate) fn may_go(stmt: &Stmt, made: &dyn Fn(LocalId) -> bool) -> bool {
    match &stmt.kind {
        StmtKind::Let { local, value: Some(_) } => made(*local),
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
