//! The initial value of a fold is evaluated after its source, so its fault comes later.

use bessemer::prelude::*;

#[function]
pub fn elements(rows: &[[u32; 3]; 2], at: usize, by: usize, first: &[u32; 2]) -> u32 {
    rows[at % by].iter().fold(first[at], |sum, x| sum.wrapping_add(*x))
}

#[function]
pub fn listed(rows: &List<List<u32, 4>, 3>, limit: usize) -> u32 {
    rows[limit % rows.len()].iter().take(2).filter(|&x| *x > 3).fold(rows[2][0], |sum, x| sum ^ *x)
}

#[function]
pub fn counted(a: i32, b: i32, values: &[i32; 3], at: usize) -> i32 {
    (0..a / b % 8).fold(values[at], |sum, x| sum.wrapping_add(x))
}

#[function]
pub fn skipped(values: &[i32; 4], at: usize, a: usize, b: usize) -> i32 {
    values.iter().skip(a / b).fold(values[at], |sum, x| sum.wrapping_add(*x))
}

#[function]
pub fn next(place: &mut usize) -> usize {
    *place = (*place + 1) % 3;
    *place
}

#[function]
pub fn by_turns(rows: &[[i32; 2]; 3], place: &mut usize) -> i32 {
    rows[next(place)].iter().fold(rows[next(place)][0], |sum, x| sum.wrapping_mul(3).wrapping_add(*x))
}

#[function]
pub fn kept(rows: &[[i32; 2]; 3], at: usize) -> i32 {
    rows[at].iter().fold(7, |sum, x| sum.wrapping_mul(3).wrapping_add(*x))
}
