//! Finds checks of an index that a use of the index repeats.
//!
//! Lowering checks an index where Rust looks at a place. Where the place is used before anything else shows, the check that
//! each use implies suffices.
//!
//! Must not know: why lowering checks an index.

use std::collections::HashMap;

use bessemer_ir::{
    CompareOp, Expr, ExprKind, Fault, Local, LocalId, Module, Place, Step, StmtKind, Type,
};

/// An index that is a local, and the length that it has to be below.
pub(super) type Index = (LocalId, u32);

/// For each counter of a loop between literals, a number above all its values.
pub(super) type Counters = HashMap<LocalId, u64>;

/// Notes the counter of a loop between literals.
pub(super) fn count(counters: &mut Counters, stmt: &StmtKind) {
    let StmtKind::For { variable, from, to, inclusive, .. } = stmt else { return };
    let number = |expr: &Expr| match (&expr.kind, expr.ty.as_int()) {
        (ExprKind::Literal(word), Some(int)) => u64::try_from(int.from_word(*word)).ok(),
        _ => None,
    };
    let above = match (number(from), number(to)) {
        (Some(_), Some(to)) => to.saturating_add(u64::from(*inclusive)),
        _ => u64::MAX,
    };
    let known = counters.entry(*variable).or_default();
    *known = above.max(*known);
}

/// Returns the local and the length of a check that the local is an index below that length.
pub(super) fn index_check(stmt: &StmtKind) -> Option<Index> {
    let StmtKind::Check { condition, fault: Fault::Index } = stmt else { return None };
    let ExprKind::Compare(CompareOp::Lt, index, len) = &condition.kind else { return None };
    match len.kind {
        ExprKind::Literal(len) => Some((local(index)?, u32::try_from(len).ok()?)),
        _ => None,
    }
}

/// Returns the local that a value is.
pub(super) fn local(value: &Expr) -> Option<LocalId> {
    match &value.kind {
        ExprKind::Load(place) if place.steps.is_empty() => Some(place.root),
        _ => None,
    }
}

/// Returns the indices of each step that may be out of range by the type of the place. An index that is not a local is
/// `None`.
pub(super) fn doubtful(
    module: &Module,
    locals: &[Local],
    counters: &Counters,
    place: &Place,
) -> Vec<Vec<Option<Index>>> {
    let mut ty = Some(locals[place.root.index()].ty.clone());
    let doubtful = place.steps.iter().map(|step| {
        let lengths = match (step, &ty) {
            (Step::Element(..), Some(Type::Matrix { rows, cols, .. })) => vec![*rows, *cols],
            (_, Some(Type::Array { len, .. })) => vec![*len],
            (_, Some(Type::Matrix { rows, cols, .. })) => vec![rows.saturating_mul(*cols)],
            _ => Vec::new(),
        };
        let lengths = lengths.into_iter().map(Some).chain(std::iter::repeat(None));
        let indices =
            step.indices().zip(lengths).filter(|(index, len)| !is_below(counters, index, *len));
        let indices = indices.map(|(index, len)| match step {
            // A slice may begin at the end.
            Step::From(_) => None,
            _ => Some((local(index)?, len?)),
        });
        let indices = indices.collect();
        ty = ty.as_ref().and_then(|ty| module.step_type(ty, step));
        indices
    });
    doubtful.collect()
}

/// Returns true if an index is below a length: a literal, or a counter.
fn is_below(counters: &Counters, index: &Expr, len: Option<u32>) -> bool {
    match (&index.kind, index.ty.as_int(), len) {
        (ExprKind::Load(_), _, Some(len)) => {
            let above = local(index).and_then(|it| counters.get(&it));
            above.is_some_and(|above| *above <= u64::from(len))
        }
        (ExprKind::Literal(word), Some(int), Some(len)) => {
            (0..i128::from(len)).contains(&int.from_word(*word))
        }
        _ => false,
    }
}
