//! Ranges as values, in a field or a parameter: the C of core's `Range` and `RangeInclusive`, a struct of the two
//! ends.
//!
//! A range in a `for` loop is not a value. A range that is one has methods for its ends and for what it contains.

// An end that is not a number leaves nothing within.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use core::ops::{Range, RangeInclusive};

use crate::Plain;
use crate::prelude::*;

/// A range that includes its end: core's `RangeInclusive`.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closed<T> {
    /// First number of the range.
    pub start: T,
    /// Last number of the range.
    pub end: T,
}

/// A range that excludes its end: core's `Range`.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfOpen<T> {
    /// First number of the range.
    pub start: T,
    /// The end, which the range excludes.
    pub end: T,
}

/// The range `start..=end`.
#[function(expand)]
pub fn closed<T: Copy>(start: T, end: T) -> Closed<T> {
    Closed { start, end }
}

/// First number of a range that includes its end.
#[function]
pub fn start<T: Copy>(range: &Closed<T>) -> &T {
    &range.start
}

/// Last number of a range that includes its end.
#[function]
pub fn end<T: Copy>(range: &Closed<T>) -> &T {
    &range.end
}

/// Returns true if a number is not below the start and not above the end.
#[function]
pub fn closed_contains<T: Copy + PartialOrd>(range: &Closed<T>, number: &T) -> bool {
    range.start <= *number && *number <= range.end
}

/// Returns true if a number is not below the start, and below the end.
#[function]
pub fn contains<T: Copy + PartialOrd>(range: &HalfOpen<T>, number: &T) -> bool {
    range.start <= *number && *number < range.end
}

/// Returns true if the end is below the start.
#[function]
pub fn closed_is_empty<T: Copy + PartialOrd>(range: &Closed<T>) -> bool {
    !(range.start <= range.end)
}

/// Returns true if the end is not above the start.
#[function]
pub fn is_empty<T: Copy + PartialOrd>(range: &HalfOpen<T>) -> bool {
    !(range.start < range.end)
}

/// Defines the functions that count the integers in a range, one for each integer type.
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
