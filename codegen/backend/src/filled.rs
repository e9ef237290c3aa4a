//! Finds arrays and matrices of which a loop assigns each element before it is read. Their first value is never read, so
//! the C has none.
//!
//! Invariant: on each path, every element of such a local is assigned before anything reads it. A pass reads only what it
//! or an earlier one assigned. In doubt, the first value stays. Must not know: the C text.

use std::collections::BTreeSet;

use bessemer_ir::effects::mentions;
use bessemer_ir::visit::Walk as _;
use bessemer_ir::{
    BinaryOp, Block, Expr, ExprKind, LocalId, Module, Place, Step, Stmt, StmtKind, Type,
};

/// Returns true if a loop of `rest`, the first statement that mentions `local`, assigns each of its elements.
pub(crate) fn filled(module: &Module, local: LocalId, ty: &Type, rest: &[Stmt]) -> bool {
    let Some(first) = rest.iter().find(|stmt| mentions(*stmt, local)) else {
        return false;
    };
    let Some((outer, to, body)) = through(module, first) else { return false };
    // A pass that leaves the loop leaves the rest of the elements as they are.
    if leaves_with(first, local) {
        return false;
    }
    if let Type::Matrix { rows, cols, .. } = *ty {
        let is_of_columns = to == cols && in_columns(module, local, rows, outer, body);
        if is_of_columns || in_lines(local, ty, (outer, to), body) {
            return true;
        }
        if let [inner] = body.0.as_slice()
            && let Some((row, last, body)) = through(module, inner)
        {
            // By columns, or by rows.
            let (inner, outer) = (Some(row), Some(outer));
            return (to, last) == (cols, rows) && assigns(local, &[inner, outer], body)
                || (to, last) == (rows, cols) && assigns(local, &[outer, inner], body);
        }
    }
    let (count, element) = match *ty {
        Type::Array { len, .. } => (len, vec![Some(outer)]),
        Type::Matrix { rows, cols: 1, .. } => (rows, vec![Some(outer), None]),
        Type::Matrix { rows: 1, cols, .. } => (cols, vec![None, Some(outer)]),
        Type::Matrix { rows, cols, .. } => (rows * cols, vec![Some(outer)]),
        _ => return false,
    };
    let one_index = matches!(element.as_slice(), [Some(_)]);
    to == count && (assigns(local, &element, body) || in_order(local, &element, outer, body))
        || one_index && in_tiles(module, local, count, (outer, to), body)
}

/// Returns true if each pass of a loop over the columns assigns the elements of its column in order, before it uses them.
fn in_columns(module: &Module, local: LocalId, rows: u32, column: LocalId, body: &Block) -> bool {
    let Some(first) = body.0.iter().position(|stmt| mentions(stmt, local)) else { return false };
    let Some((row, to, inner)) = through(module, &body.0[first]) else { return false };
    let elsewhere = |place: &Place, _| {
        let is_here =
            matches!(place.steps.as_slice(), [Step::Element(_, at)] if counts(at, column));
        place.root == local && !is_here
    };
    to == rows
        && in_order(local, &[Some(row), Some(column)], row, inner)
        && !body.0[first + 1..].any_place(elsewhere)
}

/// Returns true if each pass of a loop assigns the element at these counters (none: at 0). Before, it uses only elements of
/// earlier passes, by the counters of loops from 0 to `counter`, the loop's own.
fn in_order(local: LocalId, at: &[Option<LocalId>], counter: LocalId, body: &Block) -> bool {
    let mut below = Vec::new();
    body.each_stmt(|stmt| match &stmt.kind {
        StmtKind::For { variable, from, to, inclusive: false, ended: false, .. }
            if matches!(from.kind, ExprKind::Literal(0)) && counts(to, counter) =>
        {
            below.push(*variable);
        }
        _ => {}
    });
    let is_earlier = |place: &Place| {
        let of = |k: &LocalId| -> Vec<Option<LocalId>> {
            at.iter().map(|it| if *it == Some(counter) { Some(*k) } else { *it }).collect()
        };
        below.iter().any(|k| is_element(place, &of(k)))
    };
    let is_own = |stmt: &Stmt| matches!(&stmt.kind, StmtKind::Assign { place, .. } if place.root == local && is_element(place, at));
    let Some(own) = body.0.iter().position(is_own) else { return false };
    let StmtKind::Assign { value, .. } = &body.0[own].kind else { return false };
    let too_early = |place: &Place, _| place.root == local && !is_earlier(place);
    let another =
        |place: &Place, _| place.root == local && !is_earlier(place) && !is_element(place, at);
    !body.0[..own].any_place(too_early)
        && !value.any_place(too_early)
        && !body.0[own + 1..].any_place(another)
}

/// Returns true if each pass of a loop assigns all elements of one column, or of one row, one by one. The body does not use
/// the matrix otherwise.
fn in_lines(local: LocalId, ty: &Type, (counter, to): (LocalId, u32), body: &Block) -> bool {
    let Type::Matrix { rows, cols, .. } = *ty else { return false };
    let counts = |index: &Expr| counts(index, counter);
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
    let next = |index: &Expr| match &index.kind {
        ExprKind::Binary(BinaryOp::Add, start, at) => {
            let starts = matches!(&start.kind, ExprKind::Binary(BinaryOp::Mul, of, by)
                if counts(of, tile) && by.kind == ExprKind::Literal(width.into()));
            starts && counts(at, n)
        }
        _ => false,
    };
    let is_next = matches!(place.steps.as_slice(), [Step::Index(index)] if next(index));
    is_next
        && place.root == local
        && !mentions(value, local)
        && tiles.checked_mul(width) == Some(count)
}

/// Returns the counter of a loop from 0, its end and its body.
pub(crate) fn through<'s>(module: &Module, stmt: &'s Stmt) -> Option<(LocalId, u32, &'s Block)> {
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

/// Returns true for the value of a counter.
fn counts(index: &Expr, counter: LocalId) -> bool {
    matches!(&index.kind, ExprKind::Load(place) if place.root == counter && place.steps.is_empty())
}

/// Returns true for the element at these counters (none: at 0).
pub(crate) fn is_element(place: &Place, at: &[Option<LocalId>]) -> bool {
    let is = |index: &Expr, at: &Option<LocalId>| match at {
        Some(counter) => counts(index, *counter),
        None => matches!(index.kind, ExprKind::Literal(0)),
    };
    match (place.steps.as_slice(), at) {
        ([Step::Index(index)], [counter]) => is(index, counter),
        ([Step::Element(row, column)], [first, second]) => is(row, first) && is(column, second),
        _ => false,
    }
}

/// Returns true if a statement may leave a loop, or the function with the value of a local.
fn leaves_with(stmt: &Stmt, local: LocalId) -> bool {
    stmt.any_stmt(|stmt| match &stmt.kind {
        StmtKind::Break | StmtKind::Continue => true,
        StmtKind::Return(value) => value.as_ref().is_some_and(|value| mentions(value, local)),
        _ => false,
    })
}
