//! Slices cut into parts, each handed to `__each`: core's `split`, `split_inclusive` and `chunk_by`.
//!
//! Invariants: the closure is asked of each element, or of each pair, once and in order; nothing stands behind `__each` in its
//! pass.

use crate::function;

/// The parts between the elements that are as `is_end` asks, which are in none of them. The last part is what stands behind
/// the last of these, and may be empty.
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

/// Parts of a slice, each with the element that ends it.
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

/// The parts in which each two neighbours are as `belong` asks.
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
