//! Functions of the DSL that move the elements of slices and compare their ends.

use crate::function;

/// Moves the first `by` elements behind the others.
#[function]
pub fn rotate_left<T: Copy>(values: &mut [T], by: usize) {
    assert!(by <= values.len());
    values[..by].reverse();
    values[by..].reverse();
    values.reverse();
}

/// Moves the last `by` elements before the others.
#[function]
pub fn rotate_right<T: Copy>(values: &mut [T], by: usize) {
    assert!(by <= values.len());
    values.reverse();
    values[..by].reverse();
    values[by..].reverse();
}

/// Copies the elements from `from` to `to` to where `place` is, which may be among them.
#[function]
pub fn copy_within<T: Copy>(values: &mut [T], from: usize, to: usize, place: usize) {
    crate::__inside!(from <= to && to <= values.len());
    let count = to - from;
    crate::__inside!(place <= values.len() - count);
    if place <= from {
        for i in 0..count {
            values[place + i] = values[from + i];
        }
    } else {
        for i in (0..count).rev() {
            values[place + i] = values[from + i];
        }
    }
}

/// The same of all elements from `from` on.
#[function]
pub fn copy_behind_within<T: Copy>(values: &mut [T], from: usize, place: usize) {
    copy_within(values, from, values.len(), place);
}

/// Whether the first elements are these.
#[function]
pub fn starts_with<T: Copy + PartialEq>(values: &[T], start: &[T]) -> bool {
    start.len() <= values.len() && values[..start.len()] == *start
}

/// Whether the last elements are these.
#[function]
pub fn ends_with<T: Copy + PartialEq>(values: &[T], end: &[T]) -> bool {
    end.len() <= values.len() && values[values.len() - end.len()..] == *end
}
