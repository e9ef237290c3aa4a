//! Parts of a matched tuple and arguments of a closure that a later part, a later argument or a guard writes.
//! Each keeps the value that it had where it was evaluated.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    pub level: u8,
    pub parts: [u8; 3],
    pub last: Option<u8>,
}

#[function]
fn changed(cell: &mut Cell, by: u8) -> u8 {
    cell.level = cell.level.wrapping_mul(3).wrapping_add(by);
    cell.parts[usize::from(by % 3)] ^= cell.level;
    cell.last = cell.last.map(|last| last.wrapping_add(by));
    cell.level
}

#[function]
fn mixed(one: u8, other: u8) -> u8 {
    one.wrapping_mul(7) ^ other
}

/// A later part of the tuple writes.
#[function]
pub fn later_parts(start: Cell, by: u8) -> u8 {
    let mut cell = start;
    let mut n = by;
    let local = match (n, { n = n.wrapping_add(3); n }) {
        (x, y) if x > 9 => mixed(x, y),
        (x, y) => mixed(y, x),
    };
    let field = match (cell.level, changed(&mut cell, by)) {
        (x, y) if x % 2 == 0 => mixed(x, y),
        (x, y) => mixed(y, x),
    };
    let element = match (cell.parts[1], cell.parts[2], changed(&mut cell, by)) {
        (0, x, y) => mixed(x, y),
        (x, y, z) => mixed(x, mixed(y, z)),
    };
    let whole = match (cell, changed(&mut cell, by)) {
        (Cell { level, parts: [_, x, _], last: None }, y) => mixed(level, mixed(x, y)),
        (Cell { last: Some(x), level, .. }, y) => mixed(level, mixed(x, y)),
    };
    let payload = match (cell.last, changed(&mut cell, by)) {
        (Some(x), y) => mixed(x, y),
        (None, y) => y,
    };
    let nested = match ((n, cell.level), (changed(&mut cell, by), { n = 1; n })) {
        ((w, x), (y, z)) => mixed(w, mixed(x, mixed(y, z))),
    };
    [local, field, element, whole, payload, nested].iter().fold(n, |so_far, x| mixed(so_far, *x))
}

/// A guard writes.
#[function]
pub fn guards(start: Cell, by: u8) -> u8 {
    let mut cell = start;
    let mut n = by;
    let local = match (n, by) {
        (x, y) if { n = n.wrapping_add(7); n > 90 } => mixed(x, y),
        (x, y) if { n ^= x; n > y } => mixed(y, x),
        (x, _) => mixed(x, n),
    };
    let field = match (cell.level, n) {
        (x, y) if changed(&mut cell, by) > x => mixed(x, y),
        (x, y) => mixed(y, mixed(x, cell.level)),
    };
    let element = match (cell.parts[usize::from(by % 3)], cell.last) {
        (x, Some(y)) if changed(&mut cell, by) > y => mixed(x, y),
        (x, y) => mixed(x, y.unwrap_or(cell.level)),
    };
    let whole = match (cell, n) {
        (Cell { level, .. }, y) if changed(&mut cell, by) > level => mixed(level, y),
        (Cell { parts: [x, ..], last, .. }, _) => mixed(x, last.unwrap_or(5)),
    };
    [local, field, element, whole].iter().fold(n, |so_far, x| mixed(so_far, *x))
}

/// A later argument of a closure writes.
#[function]
pub fn arguments(start: Cell, by: u8) -> u8 {
    let mut cell = start;
    let mut n = by;
    let both = |x: u8, y: u8| mixed(x, y);
    let local = both(n, { n = n.wrapping_add(3); n });
    let field = both(cell.level, changed(&mut cell, by));
    let element = both(cell.parts[1], changed(&mut cell, by));
    let whole = |x: Cell, y: u8| mixed(x.level, mixed(x.parts[2], y));
    let all = whole(cell, changed(&mut cell, by));
    let payload = |x: Option<u8>, y: u8| x.map_or(y, |x| mixed(x, y));
    let last = payload(cell.last, changed(&mut cell, by));
    let tuple = |(x, y): (u8, u8), z: u8| mixed(x, mixed(y, z));
    let parts = tuple((n, cell.level), { n = changed(&mut cell, by); n });
    [local, field, element, all, last, parts].iter().fold(n, |so_far, x| mixed(so_far, *x))
}
