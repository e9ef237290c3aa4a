//! Ranges that are held, as a field or a parameter: what core's `Range` and `RangeInclusive` are in the C, their two ends.
//!
//! A range that a loop goes through is no value: it stands in the `for`. Of one that is held its ends are asked, and what
//! it contains.

// An end that is not a number leaves nothing within.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use core::ops::{Range, RangeInclusive};

use crate::Plain;
use crate::prelude::*;

/// From the first to the last.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closed<T> {
    /// The first.
    pub start: T,
    /// The last.
    pub end: T,
}

/// From the first to before the end.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfOpen<T> {
    /// The first.
    pub start: T,
    /// Excluded end.
    pub end: T,
}

/// `start..=end`.
#[function(expand)]
pub fn closed<T: Copy>(start: T, end: T) -> Closed<T> {
    Closed { start, end }
}

/// The first.
#[function]
pub fn start<T: Copy>(range: &Closed<T>) -> &T {
    &range.start
}

/// The last.
#[function]
pub fn end<T: Copy>(range: &Closed<T>) -> &T {
    &range.end
}

/// Returns true if a number is neither below the first nor above the last.
#[function]
pub fn closed_contains<T: Copy + PartialOrd>(range: &Closed<T>, number: &T) -> bool {
    range.start <= *number && *number <= range.end
}

/// Returns true if a number is not below the first, and below the end.
#[function]
pub fn contains<T: Copy + PartialOrd>(range: &HalfOpen<T>, number: &T) -> bool {
    range.start <= *number && *number < range.end
}

/// Returns true if the last is below the first.
#[function]
pub fn closed_is_empty<T: Copy + PartialOrd>(range: &Closed<T>) -> bool {
    !(range.start <= range.end)
}

/// Returns true if the end is not above the first.
#[function]
pub fn is_empty<T: Copy + PartialOrd>(range: &HalfOpen<T>) -> bool {
    !(range.start < range.end)
}

/// Writes the lengths of ranges.
macro_rules! lengths {
    ($($length:ident: $int:ident,)*) => {$(
        /// Number of integers in a range.
        #[function]
        pub fn $length(range: &HalfOpen<$int>) -> usize {
            if range.start < range.end { range.end.abs_diff(range.start) as usize } else { 0 }
        }
    )*};
}

lengths! {
    len_u8: u8,
    len_u16: u16,
    len_u32: u32,
    len_usize: usize,
    len_i8: i8,
    len_i16: i16,
    len_i32: i32,
    len_isize: isize,
}

#[diagnostic::do_not_recommend]
impl<T: Plain> Plain for RangeInclusive<T> {
    const WORDS: usize = 2 * T::WORDS;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        self.start().store(out);
        self.end().store(out);
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        let start = T::load(next);
        start..=T::load(next)
    }
}

#[diagnostic::do_not_recommend]
impl<T: Plain> Plain for Range<T> {
    const WORDS: usize = 2 * T::WORDS;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        self.start.store(out);
        self.end.store(out);
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        let start = T::load(next);
        start..T::load(next)
    }
}
