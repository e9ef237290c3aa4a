//! A case.
#![no_std]
use bessemer::prelude::*;

/// Something with nothing in it.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Empty {
    /// No spares.
    pub spares: [u8; 0],
    /// A level.
    pub level: u8,
}

/// An error of the type is reported once, at its place.
#[function]
pub fn level(empty: &Empty) -> u8 {
    empty.level
}

/// The bits that differ.
#[function]
pub fn parity(words: &[u32]) -> u32 {
    words.iter().fold(0, |all, word| all ^ word)
}

/// An array of nothing.
#[function]
pub fn none() -> usize {
    let none: [i32; 0] = [];
    none.len()
}

/// An array of `()`.
#[function]
pub fn units() -> usize {
    let units = [(); 3];
    units.len()
}

/// A slice of nothing.
#[function]
pub fn nothing() -> u32 {
    parity(&[])
}

/// A scalar product of integers.
#[function]
pub fn weighted(weights: &Vector3<i32>, levels: &Vector3<i32>) -> i32 {
    weights.dot(levels)
}
