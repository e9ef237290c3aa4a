//! Finds arrays and structs that are overwritten after their declaration, part by part. Such a first value is never read, so C
//! omits it; in a partly filled array only the rest is initialised.
//!
//! Invariant: every element or field that [`rewritten`] or [`spared`] report, or that [`unwritten`] does not return, is
//! assigned on each path before anything reads it.

use std::collections::BTreeSet;

use bessemer_ir::visit::Walk;
use bessemer_ir::{
    BinaryOp, Expr, ExprKind, Form, LocalId, Module, Place, Step, Stmt, StmtKind, Type,
};

use bessemer_ir::effects::{mentions, whole};

use crate::filled::{is_element, through};

/// Largest number of elements of an array that are tracked one by one.
const MOST: u32 = 4096;

/// Returns the ranges of an array's elements that are not written before the array is otherwise used. Counters and
/// literals determine the written ones.
pub(super) fn unwritten(
    module: &Module,
    local: LocalId,
    ty: &Type,
    rest: &[Stmt],
) -> Vec<(u32, u32)> {
    let count = match *ty {
        Type::Array { len, .. } => len,
        Type::Matrix { rows, cols: 1, .. } => rows,
        _ => return vec![(0, u32::MAX)],
    };
    if count > MOST {
        return vec![(0, count)];
    }
    let mut written = vec![false; count as usize];
    for stmt in rest {
        let before = written.clone();
        let wrote = match through(module, stmt) {
            // A loop without passes writes nothing.
            Some((_, 0, _)) => continue,
            Some((counter, to, body)) => {
                each(module, local, &body.0, Some((counter, to)), &mut written)
            }
            None => each(module, local, [stmt], None, &mut written),
        };
        // A pass that reads may see what a later one would write.
        if !wrote || leaves(stmt) {
            written = before;
            break;
        }
    }
    let mut gaps: Vec<(u32, u32)> = Vec::new();
    for at in (0..count).filter(|at| !written[*at as usize]) {
        match gaps.last_mut() {
            Some((_, end)) if *end == at => *end += 1,
            _ => gaps.push((at, at + 1)),
        }
    }
    gaps
}

/// Marks the elements that these statements write, in each pass of a loop; none if one uses the array otherwise.
fn each<'s>(
    module: &Module,
    local: LocalId,
    stmts: impl IntoIterator<Item = &'s Stmt>,
    counter: Option<(LocalId, u32)>,
    written: &mut [bool],
) -> bool {
    for stmt in stmts {
        let place = match &stmt.kind {
            StmtKind::Assign { place, value } if place.root == local => {
                if mentions(value, local) {
                    return false;
                }
                place
            }
            _ if mentions(stmt, local) => return false,
            _ => continue,
        };
        let ([Step::Index(index)] | [Step::Element(index, _)]) = place.steps.as_slice() else {
            return false;
        };
        let Some((first, counts)) = position(module, index, counter) else { return false };
        let many = if counts { counter.map_or(1, |(_, to)| to) } else { 1 };
        for at in first..first.saturating_add(u64::from(many)) {
            match usize::try_from(at).ok().and_then(|at| written.get_mut(at)) {
                Some(written) => *written = true,
                None => return false,
            }
        }
    }
    true
}

/// Returns the offset that is added to a counter, and true if there is one.
fn position(module: &Module, index: &Expr, counter: Option<(LocalId, u32)>) -> Option<(u64, bool)> {
    match &index.kind {
        ExprKind::Literal(word) => Some((*word, false)),
        ExprKind::Const(id) => Some((*module.consts[id.index()].words.first()?, false)),
        ExprKind::Load(place) => (place.steps.is_empty()
            && Some(place.root) == counter.map(|(id, _)| id))
        .then_some((0, true)),
        ExprKind::Binary(BinaryOp::Add, left, right) => {
            let ((a, one), (b, other)) =
                (position(module, left, counter)?, position(module, right, counter)?);
            (!(one && other)).then_some((a.checked_add(b)?, one || other))
        }
        _ => None,
    }
}

/// Returns true if the statements after a struct's declaration write each of its fields before it is otherwise used. A
/// field is written as a whole, or as an array by a loop over all of it.
pub(super) fn rewritten(module: &Module, local: LocalId, ty: &Type, rest: &[Stmt]) -> bool {
    let Type::Struct(id) = ty else { return false };
    let item = &module.structs[id.index()];
    if item.form != Form::Record {
        return false;
    }
    let mut left: BTreeSet<u32> = (0..item.fields.len() as u32).collect();
    for stmt in rest {
        if leaves(stmt) {
            return false;
        }
        let (counter, body) = match through(module, stmt) {
            Some((counter, to, body)) if to > 0 => (Some((counter, to)), body.0.as_slice()),
            _ => (None, std::slice::from_ref(stmt)),
        };
        for stmt in body.iter().filter(|stmt| mentions(*stmt, local)) {
            let StmtKind::Assign { place, value } = &stmt.kind else { return false };
            if place.root != local || mentions(value, local) {
                return false;
            }
            match (place.steps.as_slice(), counter) {
                ([Step::Field(field)], _) => left.remove(field),
                ([Step::Field(field), element], Some((counter, to)))
                    if is_each(&item.fields[*field as usize].ty, element, counter, to) =>
                {
                    left.remove(field)
                }
                _ => return false,
            };
        }
        if left.is_empty() {
            return true;
        }
    }
    false
}

/// Returns the fields of a struct whose equal elements a loop overwrites before anything else uses them.
pub(super) fn spared(module: &Module, local: LocalId, value: &Expr, rest: &[Stmt]) -> Vec<usize> {
    let (ExprKind::Struct(items), Type::Struct(id)) = (&value.kind, &value.ty) else {
        return Vec::new();
    };
    let item = &module.structs[id.index()];
    let is_filled = |(field, item): (usize, &Expr)| match &item.kind {
        ExprKind::Splat(each) => {
            matches!(each.kind, ExprKind::Literal(_))
                && overwrites(module, local, (field as u32, &item.ty), rest)
        }
        _ => false,
    };
    let record = matches!(item.form, Form::Record);
    (0..items.len()).filter(|at| record && is_filled((*at, &items[*at]))).collect()
}

/// Returns true if the first statement that uses a field is a loop that assigns each of its elements.
fn overwrites(module: &Module, local: LocalId, (field, ty): (u32, &Type), rest: &[Stmt]) -> bool {
    let touches = |place: &Place, _| {
        place.root == local
            && !matches!(place.steps.first(), Some(Step::Field(other)) if *other != field)
    };
    for stmt in rest {
        if leaves(stmt) {
            return false;
        }
        if !stmt.any_place(touches) {
            continue;
        }
        let Some((counter, to, body)) = through(module, stmt).filter(|(_, to, _)| *to > 0) else {
            return false;
        };
        let mut used = body.0.iter().filter(|stmt| stmt.any_place(touches));
        let (first, others) = (used.next().map(|stmt| &stmt.kind), used.next());
        return others.is_none()
            && matches!(first, Some(StmtKind::Assign { place, value })
                if matches!(place.steps.as_slice(), [Step::Field(_), element] if is_each(ty, element, counter, to))
                    && !value.any_place(touches));
    }
    false
}

/// Returns true if a step leads to each element of an array or a vector as `counter` goes from 0 to `to`.
fn is_each(ty: &Type, step: &Step, counter: LocalId, to: u32) -> bool {
    let place = |steps| Place { steps, ..whole(counter) };
    let (len, at) = match *ty {
        Type::Array { len, .. } => (len, vec![Some(counter)]),
        Type::Matrix { rows, cols: 1, .. } if matches!(step, Step::Index(_)) => {
            (rows, vec![Some(counter)])
        }
        Type::Matrix { rows, cols: 1, .. } => (rows, vec![Some(counter), None]),
        _ => return false,
    };
    len == to && is_element(&place(vec![step.clone()]), &at)
}

/// Returns true if a statement may leave a loop or the function.
fn leaves(stmt: &Stmt) -> bool {
    stmt.any_stmt(|stmt| {
        matches!(stmt.kind, StmtKind::Break | StmtKind::Continue | StmtKind::Return(_))
    })
}

/// Returns the number of elements of an array or a matrix.
pub(super) fn length(ty: &Type) -> u32 {
    match ty {
        Type::Array { len, .. } => *len,
        Type::Matrix { rows, cols, .. } => rows * cols,
        _ => 1,
    }
}
