//! An element out of range is a fault, even if nothing of it is used, or only its length.

use bessemer::prelude::*;

/// Tables of an author's types.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tables {
    /// Rows of numbers.
    pub rows: [[i16; 3]; 2],
}

#[function]
pub fn length(tables: &Tables, i: usize) -> usize {
    tables.rows[i].len()
}

#[function]
pub fn filled(tables: &mut Tables, i: usize, count: usize, value: i16) {
    tables.rows[i][..count % 4].fill(value);
}

#[function]
pub fn among(tables: &Tables, i: usize, count: usize, value: i16) -> bool {
    tables.rows[i][..count % 4].contains(&value)
}

#[function]
pub fn exchanged(tables: &mut Tables, i: usize, one: usize, other: usize) {
    tables.rows[i].swap(one, other);
}

#[function]
pub fn behind(tables: &Tables, i: usize, count: usize) -> i16 {
    let mut sum = 0_i16;
    for value in tables.rows[i].iter().skip(count % 4) {
        sum = sum.wrapping_add(*value);
    }
    sum
}

#[function]
pub fn none_wider(tables: &Tables, i: usize) -> usize {
    tables.rows[i].windows(4).count()
}

#[function]
pub fn paired(tables: &Tables, i: usize, count: usize) -> usize {
    tables.rows[0][..count % 4].iter().zip(tables.rows[i].iter()).count()
}

/// A type that is not `Copy`.
#[data]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Held {
    /// First number.
    pub first: i16,
    /// Second number.
    pub second: i16,
}

#[function]
pub fn exchanged_whole(values: &[i16; 3], one: usize, other: usize) -> [i16; 2] {
    let held = |first: i16| Held { first, second: 2 };
    let mut all = [held(values[0]), held(values[1]), held(values[2])];
    all[1..].swap(one, other);
    all.swap(0, other);
    [all[1].first, all[0].first]
}
