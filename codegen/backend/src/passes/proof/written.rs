//! Places that statements and expressions may write, as the proof computes them.
//!
//! Meaning: in each execution, all memory that changes is in one of the targets. A non-literal index may be any, as
//! may a row and a column; assigning an equal value counts as a write, too.
//!
//! Invariant: exhaustive over the forms of the IR, so a new form does not compile until it is handled here. Must not
//! know: `effects`, `bessemer_ir::visit`, or other code that the analysis uses, since an error there must not affect
//! both.

use bessemer_ir::{Argument, Block, Expr, ExprKind, LocalId, Place, Step, Stmt, StmtKind};

use super::linear::Linear;
use super::values::At;

/// A part of a local, or all of it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Target {
    pub(super) local: LocalId,
    pub(super) at: Vec<At>,
}

impl Target {
    pub(super) fn whole(local: LocalId) -> Target {
        Target { local, at: Vec::new() }
    }

    fn of(place: &Place) -> Target {
        Target { local: place.root, at: place.steps.iter().map(plain).collect() }
    }

    /// Returns true if the two may share memory.
    pub(super) fn meets(&self, other: &Target) -> bool {
        self.local == other.local && !self.at.iter().zip(&other.at).any(|(a, b)| apart(a, b))
    }
}

/// Returns the places that statements may write, including the locals that they declare.
pub(crate) fn by_stmts<'a>(stmts: impl IntoIterator<Item = &'a Stmt>) -> Vec<Target> {
    let mut targets = Vec::new();
    stmts.into_iter().for_each(|stmt| by_stmt(stmt, &mut targets));
    targets
}

/// Returns the places that an expression may write: those that it borrows mutably for calls.
pub(super) fn by_expr(expr: &Expr) -> Vec<Target> {
    let lent = named(expr).into_iter().filter(|(_, lent)| *lent);
    lent.map(|(place, _)| Target::of(place)).collect()
}

/// Returns true if an expression reads or borrows memory of one of the targets.
pub(crate) fn touches(expr: &Expr, targets: &[Target]) -> bool {
    let named: Vec<Target> = named(expr).into_iter().map(|(place, _)| Target::of(place)).collect();
    named.iter().any(|named| targets.iter().any(|target| target.meets(named)))
}

fn by_stmt(stmt: &Stmt, targets: &mut Vec<Target>) {
    let (mut exprs, mut blocks): (Vec<&Expr>, Vec<&Block>) = (Vec::new(), Vec::new());
    match &stmt.kind {
        StmtKind::Let { local, value } => {
            exprs.extend(value);
            targets.push(Target::whole(*local));
        }
        StmtKind::Assign { place, value } => {
            exprs.push(value);
            exprs.extend(indices(place));
            targets.push(Target::of(place));
        }
        StmtKind::Expr(expr) | StmtKind::Check { condition: expr, .. } => exprs.push(expr),
        StmtKind::If { condition, then, otherwise } => {
            exprs.push(condition);
            blocks.extend([then, otherwise]);
        }
        StmtKind::Match { scrutinee, arms, otherwise } => {
            exprs.push(scrutinee);
            blocks.extend(arms.iter().map(|arm| &arm.body));
            blocks.extend(otherwise);
        }
        StmtKind::For { variable, from, to, body, .. } => {
            exprs.extend([from, to]);
            targets.push(Target::whole(*variable));
            blocks.push(body);
        }
        StmtKind::Return(value) => exprs.extend(value),
        StmtKind::Break | StmtKind::Continue => {}
    }
    targets.extend(exprs.into_iter().flat_map(by_expr));
    blocks.into_iter().flat_map(|block| &block.0).for_each(|stmt| by_stmt(stmt, targets));
}

/// Returns all places in an expression, also in its indices, each with true if a call borrows it mutably.
fn named(expr: &Expr) -> Vec<(&Place, bool)> {
    let (mut found, mut open) = (Vec::new(), vec![expr]);
    while let Some(expr) = open.pop() {
        match &expr.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => {}
            ExprKind::Load(place) => {
                found.push((place, false));
                open.extend(indices(place));
            }
            ExprKind::Unary(_, x) | ExprKind::Cast(x) | ExprKind::Splat(x) => open.push(x),
            ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) | ExprKind::Logic(_, a, b) => {
                open.extend([&**a, &**b]);
            }
            ExprKind::Intrinsic(_, operands)
            | ExprKind::Struct(operands)
            | ExprKind::Array(operands)
            | ExprKind::Matrix(operands)
            | ExprKind::Routine(_, operands) => open.extend(operands),
            ExprKind::Call(_, arguments) => {
                for argument in arguments {
                    match argument {
                        Argument::Value(value) | Argument::Ref(value) => open.push(value),
                        Argument::RefMut(place) => {
                            found.push((place, true));
                            open.extend(indices(place));
                        }
                    }
                }
            }
        }
    }
    found
}

fn indices(place: &Place) -> Vec<&Expr> {
    let of = |step| match step {
        &Step::Field(_) => Vec::new(),
        Step::Index(index) | Step::From(index) => vec![index],
        Step::Element(row, column) => vec![row, column],
    };
    place.steps.iter().flat_map(of).collect()
}

/// Returns a step in which only fields and literal indices are distinguished.
fn plain(step: &Step) -> At {
    let literal = |index: &Expr| match (&index.kind, index.ty.as_int()) {
        (ExprKind::Literal(word), Some(int)) => Some(Linear::number(int.from_word(*word))),
        _ => None,
    };
    match step {
        Step::Field(field) => At::Field(*field),
        Step::Index(index) => At::Index(literal(index).into_iter().collect()),
        Step::Element(..) | Step::From(_) => At::Index(Vec::new()),
    }
}

/// Returns true if two steps certainly lead to different parts.
pub(super) fn apart(a: &At, b: &At) -> bool {
    match (a, b) {
        (At::Field(a), At::Field(b)) => a != b,
        (At::Index(a), At::Index(b)) if a.len() == b.len() => a
            .iter()
            .zip(b)
            .any(|(a, b)| matches!((a.as_number(), b.as_number()), (Some(a), Some(b)) if a != b)),
        _ => false,
    }
}

#[cfg(test)]
mod tests;
