//! Variables whose parts are read once, so that a bar of a part is written and not added.
//!
//! Each read is at the counter of the same loop, which no other is around, and reads of one pass differ in a known index.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{Block, Expr, ExprKind, LocalId, Place, Step, Stmt, StmtKind};

/// Returns the locals whose parts are read so.
pub fn parts(block: &Block) -> BTreeSet<LocalId> {
    let mut reads = Reads::default();
    reads.block(block);
    let sound = reads.found.into_iter().filter(|(_, places)| {
        let [first, ..] = places.as_slice() else { return false };
        let counter = first.1;
        counter.is_some()
            && places.iter().all(|it| it.1 == counter && it.2)
            && (0..places.len())
                .all(|one| (0..one).all(|other| differ(&places[one].0, &places[other].0)))
    });
    sound.map(|(local, _)| local).collect()
}

/// Returns true if two places differ in a known index.
fn differ(one: &Place, other: &Place) -> bool {
    let known = |one: &Expr, other: &Expr| match (&one.kind, &other.kind) {
        (ExprKind::Literal(one), ExprKind::Literal(other)) => one != other,
        _ => false,
    };
    one.steps.iter().zip(&other.steps).any(|pair| match pair {
        (Step::Field(one), Step::Field(other)) => one != other,
        (Step::Index(one), Step::Index(other)) => known(one, other),
        (Step::Element(row, col), Step::Element(other_row, other_col)) => {
            known(row, other_row) || known(col, other_col)
        }
        _ => false,
    })
}

/// Reads of parts: the place, the counter of the loop around, if it is the only one, and true if that is an index.
#[derive(Default)]
struct Reads {
    around: Vec<LocalId>,
    found: BTreeMap<LocalId, Vec<(Place, Option<LocalId>, bool)>>,
}

impl Visit for Reads {
    fn stmt(&mut self, stmt: &Stmt) {
        if let StmtKind::For { variable, body, .. } = &stmt.kind {
            self.around.push(*variable);
            self.block(body);
            self.around.pop();
            return;
        }
        visit::walk_stmt(self, stmt);
    }

    fn place(&mut self, place: &Place, _: Access) {
        let counter = match self.around.as_slice() {
            [counter] => Some(*counter),
            _ => None,
        };
        let is = |index: &Expr| match &index.kind {
            ExprKind::Load(at) => at.steps.is_empty() && Some(at.root) == counter,
            _ => false,
        };
        let is_index = place.steps.iter().any(|step| match step {
            Step::Index(index) => is(index),
            Step::Element(row, col) => is(row) || is(col),
            _ => false,
        });
        self.found.entry(place.root).or_default().push((place.clone(), counter, is_index));
        visit::walk_place(self, place);
    }
}
