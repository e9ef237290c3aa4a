//! Disjoint parts of an array, passed as mutable references at the same time.

use bessemer::prelude::*;

/// Rows and a list that are split.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rows {
    /// Rows of bytes.
    pub rows: [[u8; 4]; 2],
    /// A list of bytes.
    pub list: List<u8, 6>,
}

/// Writes both slices; returns their common length.
#[function]
pub fn mixed(one: &mut [u8], other: &mut [u8]) -> usize {
    for (x, y) in one.iter_mut().zip(other.iter_mut()) {
        *x ^= *y;
        *y = y.wrapping_add(*x);
    }
    one.len() * 10 + other.len()
}

/// Copies one slice to the other.
#[function]
pub fn copied(to: &mut [u8], from: &[u8]) {
    for (x, y) in to.iter_mut().zip(from) {
        *x = *y;
    }
}

/// Rotates the elements of three slices.
#[function]
pub fn turned(a: &mut [u8], b: &mut [u8], c: &mut [u8]) -> u8 {
    let first = a[0];
    a[0] = b[0];
    b[0] = c[0];
    c[0] = first;
    a[0] ^ b[0]
}

/// Halves with constant ends.
#[function]
pub fn in_halves(values: &mut [u8; 8]) -> usize {
    let (low, high) = values.split_at_mut(4);
    let count = mixed(low, high) + mixed(high, low);
    copied(high, low);
    count
}

/// Three parts with any ends.
#[function]
pub fn in_three(values: &mut [u8; 8], n: usize, m: usize) -> (u8, u8) {
    let (a, rest) = values.split_at_mut(1 + n % 4);
    let (b, c) = rest.split_at_mut(m);
    (turned(a, b, c), turned(c, a, b))
}

/// Parts of parts.
#[function]
pub fn behind_the_first(values: &mut [u8; 8], n: usize) -> usize {
    let Some((first, rest)) = values.split_first_mut() else { return 0 };
    let (a, b) = rest.split_at_mut(n % 8);
    *first ^= 1;
    mixed(b, a)
}

/// Parts of a row and of a list.
#[function]
pub fn of_rows(rows: &mut Rows, n: usize, i: usize) -> usize {
    let (a, b) = rows.rows[i].split_at_mut(n % 6);
    let count = mixed(a, b);
    let (a, b) = rows.list[1..].split_at_mut(n % 4);
    count + mixed(b, a)
}
