//! Computes the places that expressions read and statements write, and which places may overlap.
//!
//! Two different locals never share memory: references are exclusive, as in Rust. The validator checks this for every
//! call, by functions of this module.
//!
//! Invariant: in doubt, there is an effect. Must not know: the callers and their conclusions.

use alloc::vec::Vec;

use crate::visit::{Access, Visit, Walk, walk_place, walk_stmt};
use crate::{BinaryOp, Expr, ExprKind, LocalId, Place, Span, Step, Stmt, StmtKind, Type};

/// Returns true if two places may share memory: they do not differ in a field or in a literal index.
pub fn overlap(a: &Place, b: &Place) -> bool {
    a.root == b.root && !a.steps.iter().zip(&b.steps).any(|(a, b)| parts(a, b))
}

/// Returns true if two steps from one place certainly lead to different parts.
fn parts(a: &Step, b: &Step) -> bool {
    match (a, b) {
        (Step::Field(a), Step::Field(b)) => a != b,
        (Step::Index(a), Step::Index(b)) => differ(a, b),
        (Step::Element(row_a, col_a), Step::Element(row_b, col_b)) => {
            differ(row_a, row_b) || differ(col_a, col_b)
        }
        _ => false,
    }
}

/// Returns true if two indices are known to differ.
fn differ(a: &Expr, b: &Expr) -> bool {
    match (&a.kind, &b.kind) {
        (ExprKind::Literal(word_a), ExprKind::Literal(word_b)) => {
            let value = |expr: &Expr, word: u64| expr.ty.as_int().map(|int| int.from_word(word));
            value(a, *word_a) != value(b, *word_b)
        }
        _ => false,
    }
}

/// Returns true if two places are equal except for their spans.
pub fn same_place(one: &Place, other: &Place) -> bool {
    let steps = || one.steps.iter().zip(&other.steps);
    one.root == other.root
        && one.steps.len() == other.steps.len()
        && steps().all(|steps| match steps {
            (Step::Field(one), Step::Field(other)) => one == other,
            (Step::Index(one), Step::Index(other)) | (Step::From(one), Step::From(other)) => {
                same_index(one, other)
            }
            (Step::Element(row, column), Step::Element(other_row, other_column)) => {
                same_index(row, other_row) && same_index(column, other_column)
            }
            _ => false,
        })
}

fn same_index(one: &Expr, other: &Expr) -> bool {
    match (&one.kind, &other.kind) {
        (ExprKind::Literal(one), ExprKind::Literal(other)) => one == other,
        (ExprKind::Const(one), ExprKind::Const(other)) => one == other,
        (ExprKind::Load(one), ExprKind::Load(other)) => same_place(one, other),
        _ => false,
    }
}

/// Returns a whole local as a written place.
pub fn whole(local: LocalId) -> Place {
    Place::local(local, Type::Unit, Span::default())
}

/// Returns true if a local is read or written.
pub fn mentions(node: &(impl Walk + ?Sized), local: LocalId) -> bool {
    node.any_place(|place, _| place.root == local)
}

/// Returns true if a local, or a part of it, is written or borrowed by a call that may write it.
pub fn writes_local(node: &(impl Walk + ?Sized), local: LocalId) -> bool {
    node.any_place(|place, access| access != Access::Read && place.root == local)
}

/// Returns true if an expression calls a function.
pub fn calls(expr: &Expr) -> bool {
    expr.any_expr(|expr| matches!(expr.kind, ExprKind::Call(..)))
}

/// Returns true if the value of `expr` may change when `written` are written.
pub fn reads(expr: &Expr, written: &[Place]) -> bool {
    expr.any_place(|place, _| written.iter().any(|written| overlap(place, written)))
}

/// Returns true if an expression reads or borrows a place.
pub fn reads_place(expr: &Expr, place: &Place) -> bool {
    expr.any_place(|read, _| overlap(read, place))
}

/// Returns true if `place` may become another place when `written` are written.
pub fn moves(place: &Place, written: &[Place]) -> bool {
    place.any_place(|place, _| written.iter().any(|written| overlap(place, written)))
}

/// Returns the places that `stmts` may write, including the locals that they declare.
pub fn writes<'a>(stmts: impl IntoIterator<Item = &'a Stmt>) -> Vec<Place> {
    let mut writes = Writes::default();
    stmts.into_iter().for_each(|stmt| writes.stmt(stmt));
    writes.0
}

#[derive(Default)]
struct Writes(Vec<Place>);

impl Visit for Writes {
    fn stmt(&mut self, stmt: &Stmt) {
        // `x = x;` changes nothing, and is dropped.
        if !is_idle(stmt) {
            walk_stmt(self, stmt);
        }
    }
    fn place(&mut self, place: &Place, access: Access) {
        if access != Access::Read {
            self.0.push(place.clone());
        }
        walk_place(self, place);
    }
    fn declaration(&mut self, local: &LocalId) {
        self.0.push(whole(*local));
    }
}

/// Returns the places that the calls in an expression, or in the indices of a place, may write.
pub fn lent(node: &impl Walk) -> Vec<Place> {
    let mut lent = Vec::new();
    node.each_place(|place, access| {
        if access != Access::Read {
            lent.push(place.clone());
        }
    });
    lent
}

/// Returns the places that the calls in an index may write.
pub fn lent_by_step(step: &Step) -> Vec<Place> {
    step.indices().flat_map(lent).collect()
}

/// Returns true if a statement assigns a place its own value.
fn is_idle(stmt: &Stmt) -> bool {
    matches!(&stmt.kind, StmtKind::Assign { place, value } if is_own(value, place))
}

/// Returns true if an assignment of `value` leaves `place` unchanged. Examples: `x = x`, `x = x | x`, or `x = x as u8`
/// of a `u8`.
pub fn is_own(value: &Expr, place: &Place) -> bool {
    match &value.kind {
        ExprKind::Load(from) => same_place(from, place),
        ExprKind::Cast(x) => x.ty == value.ty && is_own(x, place),
        ExprKind::Binary(BinaryOp::And | BinaryOp::Or, a, b) => {
            is_own(a, place) && is_own(b, place)
        }
        _ => false,
    }
}
