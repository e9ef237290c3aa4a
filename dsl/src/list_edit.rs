//! Functions that insert into lists and remove from them at any position, written in the DSL for the C.

// The checks of indices are proved of loops over them.
#![allow(clippy::needless_range_loop)]

use crate::{List, function, library};

#[library(ListEditCompanions)]
impl<T: Copy + Default, const N: usize> List<T, N> {
    /// Returns true if the list has no room for another element. The proofs recognise this comparison as the
    /// condition for a push.
    #[function(expand)]
    pub fn is_full(list: &Self) -> bool {
        list.len() >= N
    }

    /// Inserts an element at `index` and moves the elements from there on by one place.
    pub fn insert(list: &mut Self, index: usize, element: T) {
        crate::__inside!(index <= list.len());
        list.push(element);
        for i in (index + 1..list.len()).rev() {
            list[i] = list[i - 1];
        }
        list[index] = element;
    }

    /// Removes the element at `index` and moves the elements after it by one place.
    pub fn remove(list: &mut Self, index: usize) -> T {
        let element = list[index];
        for i in index + 1..list.len() {
            list[i - 1] = list[i];
        }
        list.pop();
        element
    }

    /// Removes the element at `index` and puts the last element in its place.
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

    /// Appends the elements of a slice.
    pub fn extend_from_slice(list: &mut Self, elements: &[T]) {
        for element in elements {
            list.push(*element);
        }
    }
}

/// Appends the elements of an iterator.
#[function]
pub fn extend<T: Copy + Default, const N: usize, I: IntoIterator<Item = T>>(
    list: &mut List<T, N>,
    items: I,
) {
    for item in items {
        list.push(item);
    }
}

/// Appends copies of the elements that an iterator refers to.
#[function]
pub fn extend_by<'a, T: Copy + Default + 'static, const N: usize, I: IntoIterator<Item = &'a T>>(
    list: &mut List<T, N>,
    items: I,
) {
    for item in items {
        list.push(*item);
    }
}
