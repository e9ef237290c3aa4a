//! Finds arrays, matrices and structs that are completely overwritten after their declaration. Their initial value is
//! never read, so C omits it; in a partly filled array only the rest is initialised.
//!
//! Invariant: every element that [`filled`] or [`rewritten`] report, or that [`unwritten`] does not return, is
//! assigned on each path before anything reads it.

use std::collections::BTreeSet;

use bessemer_ir::visit::Walk;
use bessemer_ir::{
    BinaryOp, Block, Expr, ExprKind, Form, LocalId, Module, Place, Step, Stmt, StmtKind, Type,
};

use bessemer_ir::effects::{mentions, whole};

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

/// Returns true if a loop of `rest`, the first statement that mentions `local`, assigns each of its elements.
pub(super) fn filled(module: &Module, local: LocalId, ty: &Type, rest: &[Stmt]) -> bool {
    let Some(first) = rest.iter().find(|stmt| mentions(*stmt, local)) else {
        return false;
    };
    let Some((outer, to, body)) = through(module, first) else { return false };
    // A pass that leaves the loop leaves the rest of the elements as they are.
    if leaves(first) {
        return false;
    }
    if let ([inner], Type::Matrix { rows, cols, .. }) = (body.0.as_slice(), ty)
        && let Some((row, last, body)) = through(module, inner)
    {
        // By columns, or by rows.
        let (inner, outer) = (Some(row), Some(outer));
        return (to, last) == (*cols, *rows) && assigns(local, &[inner, outer], body)
            || (to, last) == (*rows, *cols) && assigns(local, &[outer, inner], body);
    }
    if in_lines(local, ty, (outer, to), body) {
        return true;
    }
    let (count, element) = match *ty {
        Type::Array { len, .. } => (len, vec![Some(outer)]),
        Type::Matrix { rows, cols: 1, .. } => (rows, vec![Some(outer), None]),
        Type::Matrix { rows: 1, cols, .. } => (cols, vec![None, Some(outer)]),
        Type::Matrix { rows, cols, .. } => (rows * cols, vec![Some(outer)]),
        _ => return false,
    };
    let one_index = matches!(element.as_slice(), [Some(_)]);
    to == count && assigns(local, &element, body)
        || one_index && in_tiles(module, local, count, (outer, to), body)
}

/// Returns true if each pass of a loop assigns all elements of one column, or of one row, one by one. The body does not use
/// the matrix otherwise.
fn in_lines(local: LocalId, ty: &Type, (counter, to): (LocalId, u32), body: &Block) -> bool {
    let Type::Matrix { rows, cols, .. } = *ty else { return false };
    let counts = |index: &Expr| matches!(&index.kind, ExprKind::Load(place) if place.root == counter && place.steps.is_empty());
    let (mut in_column, mut in_row) = (BTreeSet::new(), BTreeSet::new());
    for stmt in body.0.iter().filter(|stmt| mentions(*stmt, local)) {
        let StmtKind::Assign { place, value } = &stmt.kind else { return false };
        let [Step::Element(row, column)] = place.steps.as_slice() else { return false };
        if place.root != local || mentions(value, local) {
            return false;
        }
        match (&row.kind, &column.kind) {
            (ExprKind::Literal(row), _) if counts(column) => in_column.insert(*row),
            (_, ExprKind::Literal(column)) if counts(row) => in_row.insert(*column),
            _ => return false,
        };
    }
    let all = |found: &BTreeSet<u64>, of: u32| found.iter().copied().eq(0..u64::from(of));
    to == cols && all(&in_column, rows) || to == rows && all(&in_row, cols)
}

/// Returns true if a loop in each pass of another assigns the next elements, `array[tile * 8 + n]`. No other statement
/// of the body mentions the array.
fn in_tiles(
    module: &Module,
    local: LocalId,
    count: u32,
    (tile, tiles): (LocalId, u32),
    body: &Block,
) -> bool {
    let mut used = body.0.iter().filter(|stmt| mentions(*stmt, local));
    let (Some(inner), None) = (used.next(), used.next()) else { return false };
    let Some((n, width, body)) = through(module, inner) else { return false };
    let [Stmt { kind: StmtKind::Assign { place, value }, .. }] = body.0.as_slice() else {
        return false;
    };
    let loads = |expr: &Expr, counter: LocalId| matches!(&expr.kind, ExprKind::Load(place) if place.root == counter && place.steps.is_empty());
    let next = |index: &Expr| match &index.kind {
        ExprKind::Binary(BinaryOp::Add, start, at) => {
            let starts = matches!(&start.kind, ExprKind::Binary(BinaryOp::Mul, of, by)
                if loads(of, tile) && by.kind == ExprKind::Literal(width.into()));
            starts && loads(at, n)
        }
        _ => false,
    };
    let is_next = matches!(place.steps.as_slice(), [Step::Index(index)] if next(index));
    is_next
        && place.root == local
        && !mentions(value, local)
        && tiles.checked_mul(width) == Some(count)
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

/// Returns the counter of a loop from 0, its end and its body.
fn through<'s>(module: &Module, stmt: &'s Stmt) -> Option<(LocalId, u32, &'s Block)> {
    match &stmt.kind {
        StmtKind::For { variable, from, to, inclusive: false, ended: false, body, .. } => {
            let to = match &to.kind {
                ExprKind::Literal(word) => *word,
                ExprKind::Const(id) => *module.consts[id.index()].words.first()?,
                _ => return None,
            };
            matches!(from.kind, ExprKind::Literal(0)).then_some((
                *variable,
                u32::try_from(to).ok()?,
                body,
            ))
        }
        _ => None,
    }
}

/// Returns true if each path through a block assigns the element at these counters (none: at 0) before the local is
/// otherwise used. Nothing may leave the block, and afterwards only this element is used.
fn assigns(local: LocalId, at: &[Option<LocalId>], block: &Block) -> bool {
    let Some(first) = block.0.iter().position(|stmt| mentions(stmt, local)) else { return false };
    let assigned = match &block.0[first].kind {
        StmtKind::Assign { place, value } => {
            place.root == local && is_element(place, at) && !mentions(value, local)
        }
        StmtKind::If { condition, then, otherwise } => {
            !mentions(condition, local) && assigns(local, at, then) && assigns(local, at, otherwise)
        }
        _ => false,
    };
    let another = |place: &Place, _| place.root == local && !is_element(place, at);
    assigned && !block.0[first + 1..].any_place(another)
}

fn is_element(place: &Place, at: &[Option<LocalId>]) -> bool {
    let is = |index: &Expr, at: &Option<LocalId>| match (&index.kind, at) {
        (ExprKind::Load(place), Some(counter)) => place.root == *counter && place.steps.is_empty(),
        (ExprKind::Literal(word), None) => *word == 0,
        _ => false,
    };
    match (place.steps.as_slice(), at) {
        ([Step::Index(index)], [counter]) => is(index, counter),
        ([Step::Element(row, column)], [first, second]) => is(row, first) && is(column, second),
        _ => false,
    }
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
