//! Elements whose index is read from the written value itself: the index is evaluated once, before any part is
//! written.

use bessemer::prelude::*;

/// A node of a list: its value, and the index of the next one.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Node {
    next: u8,
    value: i32,
}

/// Writes the node that follows the node `at`, which may be the same one.
#[function]
pub fn write_next(nodes: &mut [Node; 4], at: usize, value: i32) -> i32 {
    let at = at % 4;
    nodes[usize::from(nodes[at].next) % 4] = Node { next: 3, value };
    nodes[at].value
}

/// Copies the following node to a node.
#[function]
pub fn copy_next(nodes: &mut [Node; 4], at: usize) -> i32 {
    let at = at % 4;
    nodes[usize::from(nodes[at].next) % 4] = nodes[3];
    nodes[at].value
}

/// Writes a row that is selected by one of its elements.
#[function]
pub fn write_row(rows: &mut [[u8; 3]; 4], value: u8) -> u8 {
    rows[usize::from(rows[0][1].abs_diff(rows[2][0])) % 4] = [value, 7, value / 2];
    rows[2][2]
}

/// Assigns each element of a row from the one before.
#[function]
pub fn fill_row(rows: &mut [[u8; 3]; 4], value: u8) -> u8 {
    rows[usize::from(rows[1][0]) % 4] = core::array::from_fn(|at| value.wrapping_add(at as u8));
    rows[1][2]
}

/// Adds to a vector that is selected by a number in it.
#[function]
pub fn add_to_vector(table: &mut [Vector2<f64>; 3], by: f64) -> f64 {
    let step = Vector2::new(by, 1.0);
    table[(table[1][0] as usize) % 3] = step + Vector2::new(1.0, by);
    table[(table[1][1] as usize) % 3] += step;
    table[1][0] + table[2][1]
}
