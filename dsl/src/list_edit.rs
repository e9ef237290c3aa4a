//! Functions of the DSL that insert elements into lists and remove them, at any place.

// The checks of indices are proved of loops over them.
#![allow(clippy::needless_range_loop)]

use crate::{List, function, library};

#[library(ListEditCompanions)]
impl<T: Copy + Default, const N: usize> List<T, N> {
    /// True if no element can be added. The comparison is the one by which the proofs know that a push has room.
    #[function(expand)]
    pub fn is_full(list: &Self) -> bool {
        list.len() >= N
    }

    /// Puts an element before the one at `index`, or at the end.
    pub fn insert(list: &mut Self, index: usize, element: T) {
        crate::__inside!(index <= list.len());
        list.push(element);
        for i in (index + 1..list.len()).rev() {
            list[i] = list[i - 1];
        }
        list[index] = element;
    }

    /// Takes an element out; those behind it move up.
    pub fn remove(list: &mut Self, index: usize) -> T {
        let element = list[index];
        for i in index + 1..list.len() {
            list[i - 1] = list[i];
        }
        list.pop();
        element
    }

    /// Takes an element out; the last comes in its place.
    pub fn swap_remove(list: &mut Self, index: usize) -> T {
        let element = list[index];
        list[index] = list[list.len() - 1];
        list.pop();
        element
    }

    /// Keeps the elements for which `keep` holds, in their order.
    #[function(expand)]
    pub fn retain<F: FnMut(&T) -> bool>(list: &mut Self, mut keep: F) {
        let mut kept = 0;
        for at in 0..list.len() {
            let keeps = keep(&list[at]);
            if keeps {
                list[kept] = list[at];
                kept += 1;
            }
        }
        list.truncate(kept);
    }

    /// Adds elements at the end.
    pub fn extend_from_slice(list: &mut Self, elements: &[T]) {
        for element in elements {
            list.push(*element);
        }
    }
}

/// Appends what comes.
#[function]
pub fn extend<T: Copy + Default, const N: usize, I: IntoIterator<Item = T>>(
    list: &mut List<T, N>,
    items: I,
) {
    for item in items {
        list.push(item);
    }
}

/// Appends copies of what comes.
#[function]
pub fn extend_by<'a, T: Copy + Default + 'static, const N: usize, I: IntoIterator<Item = &'a T>>(
    list: &mut List<T, N>,
    items: I,
) {
    for item in items {
        list.push(*item);
    }
}
