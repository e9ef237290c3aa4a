//! Slices split into elements and parts, each passed to `__each`: core's `iter`, `split`, `split_inclusive` and `chunk_by`.
//!
//! Invariants: the closure is called with each element, or each pair, once and in order; no statement follows
//! `__each` in its pass.

use crate::function;

/// Iterates over the elements, where the syntax does not show a slice: `self.iter()` in an interface of arrays.
#[function(expand)]
pub fn iter<T>(values: &[T], mut __each: impl FnMut(&T)) {
    for value in values {
        __each(value);
    }
}

/// Iterates over the elements, which may be written.
#[function(expand)]
pub fn iter_mut<T>(values: &mut [T], mut __each: impl FnMut(&mut T)) {
    for value in values {
        __each(value);
    }
}

/// Splits at the elements for which `is_end` is true, which belong to no part. The last part follows the last of
/// these, and may be empty.
#[function(expand)]
pub fn split<T>(values: &[T], mut is_end: impl FnMut(&T) -> bool, mut __each: impl FnMut(&[T])) {
    let mut from = 0_usize;
    for end in 0..values.len() + 1 {
        if end >= values.len() || is_end(&values[end]) {
            let part = &values[from..end];
            from = end + 1;
            __each(part);
        }
    }
}

/// Splits after the elements for which `is_end` is true; each ends a part.
#[function(expand)]
pub fn split_inclusive<T>(
    values: &[T],
    mut is_end: impl FnMut(&T) -> bool,
    mut __each: impl FnMut(&[T]),
) {
    let mut from = 0_usize;
    for last in 0..values.len() {
        if is_end(&values[last]) || last + 1 >= values.len() {
            let part = &values[from..last + 1];
            from = last + 1;
            __each(part);
        }
    }
}

/// Splits where `belong` is false for two neighbours.
#[function(expand)]
pub fn chunk_by<T>(
    values: &[T],
    mut belong: impl FnMut(&T, &T) -> bool,
    mut __each: impl FnMut(&[T]),
) {
    let mut from = 0_usize;
    for last in 0..values.len() {
        if last + 1 >= values.len() || !belong(&values[last], &values[last + 1]) {
            let part = &values[from..last + 1];
            from = last + 1;
            __each(part);
        }
    }
}
