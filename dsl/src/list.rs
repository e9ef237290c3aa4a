//! A list of bounded length: like `Vec`, but with a fixed capacity and its memory inside the value.
//!
//! A push into a full list panics, as it faults in the C: nothing is ever written beyond the end.

use core::borrow::Borrow;
use core::ops::{Deref, DerefMut, Index, IndexMut};
use core::slice::SliceIndex;

use crate::Plain;

/// A list of at most `N` elements.
///
/// ```
/// use bessemer::List;
/// let mut list: List<f64, 3> = List::new();
/// list.push(1.5);
/// list.push(2.5);
/// assert_eq!((list.len(), list[1], list.pop()), (2, 2.5, Some(2.5)));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct List<T, const N: usize> {
    length: usize,
    items: [T; N],
}

impl<T: Copy + Default, const N: usize> List<T, N> {
    /// An empty list.
    pub fn new() -> Self {
        List { length: 0, items: [T::default(); N] }
    }

    /// Adds an element at the end.
    ///
    /// # Panics
    /// If the list is full.
    pub fn push(&mut self, element: T) {
        assert!(self.length < N, "the container is full");
        self.items[self.length] = element;
        self.length += 1;
    }

    /// Removes and returns the last element.
    pub fn pop(&mut self) -> Option<T> {
        if self.length == 0 {
            return None;
        }
        self.length -= 1;
        Some(self.items[self.length])
    }

    /// Removes all elements.
    pub fn clear(&mut self) {
        self.length = 0;
    }

    /// Shortens the list to `length` elements; a shorter list stays as it is.
    pub fn truncate(&mut self, length: usize) {
        if length < self.length {
            self.length = length;
        }
    }

    /// Inserts an element at `index` and moves the elements from there on by one place.
    ///
    /// # Panics
    /// If there is no such place, or no room.
    pub fn insert(&mut self, index: usize, element: T) {
        crate::list_edit::insert(self, index, element);
    }

    /// Removes the element at `index` and moves the elements after it by one place.
    ///
    /// # Panics
    /// If there is no such element.
    pub fn remove(&mut self, index: usize) -> T {
        crate::list_edit::remove(self, index)
    }

    /// Removes the element at `index` and puts the last element in its place.
    ///
    /// # Panics
    /// If there is no such element.
    pub fn swap_remove(&mut self, index: usize) -> T {
        crate::list_edit::swap_remove(self, index)
    }

    /// Appends the elements of a slice.
    ///
    /// # Panics
    ///
    /// If the capacity is exceeded: the elements before that are appended.
    pub fn extend_from_slice(&mut self, elements: &[T]) {
        crate::list_edit::extend_from_slice(self, elements);
    }

    /// Appends the elements of any iterator, or copies of the elements that it refers to.
    ///
    /// # Panics
    ///
    /// If the capacity is exceeded: the elements before that are appended.
    pub fn extend<E: Borrow<T>>(&mut self, elements: impl IntoIterator<Item = E>) {
        elements.into_iter().for_each(|element| self.push(*element.borrow()));
    }

    /// Keeps the elements for which `keep` holds, in their order.
    pub fn retain(&mut self, keep: impl FnMut(&T) -> bool) {
        crate::list_edit::retain(self, keep);
    }

    /// Shortens the list to `length`, or appends copies of `element` up to `length`.
    ///
    /// # Panics
    ///
    /// If `length` exceeds the capacity.
    pub fn resize(&mut self, length: usize, element: T) {
        assert!(length <= N, "the container is full");
        for index in self.length..length {
            self.items[index] = element;
        }
        self.length = length;
    }
}

impl<T, const N: usize> List<T, N> {
    /// Number of elements.
    pub fn len(&self) -> usize {
        self.length
    }

    /// Returns true if the list has no elements.
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Returns true if the list has no room for another element.
    pub fn is_full(&self) -> bool {
        self.length == N
    }

    /// Largest number of elements.
    pub fn capacity(&self) -> usize {
        N
    }

    /// The elements as a slice.
    pub fn as_slice(&self) -> &[T] {
        self
    }

    /// The elements as a mutable slice.
    pub fn as_mut_slice(&mut self) -> &mut [T] {
        self
    }

    /// The elements, by reference.
    pub fn iter(&self) -> core::slice::Iter<'_, T> {
        self.items[..self.length].iter()
    }

    /// Mutable references to the elements.
    pub fn iter_mut(&mut self) -> core::slice::IterMut<'_, T> {
        self.items[..self.length].iter_mut()
    }
}

impl<T: Copy + Default, const N: usize> Default for List<T, N> {
    fn default() -> Self {
        List::new()
    }
}

impl<T: PartialEq, const N: usize> PartialEq for List<T, N> {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

/// The elements that there are, as a slice.
impl<T, const N: usize> Deref for List<T, N> {
    type Target = [T];
    fn deref(&self) -> &[T] {
        &self.items[..self.length]
    }
}

impl<T, const N: usize> DerefMut for List<T, N> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.items[..self.length]
    }
}

impl<T, I: SliceIndex<[T]>, const N: usize> Index<I> for List<T, N> {
    type Output = I::Output;
    fn index(&self, index: I) -> &I::Output {
        &(**self)[index]
    }
}

impl<T, I: SliceIndex<[T]>, const N: usize> IndexMut<I> for List<T, N> {
    fn index_mut(&mut self, index: I) -> &mut I::Output {
        &mut (**self)[index]
    }
}

impl<'a, T, const N: usize> IntoIterator for &'a List<T, N> {
    type Item = &'a T;
    type IntoIter = core::slice::Iter<'a, T>;
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<'a, T, const N: usize> IntoIterator for &'a mut List<T, N> {
    type Item = &'a mut T;
    type IntoIter = core::slice::IterMut<'a, T>;
    fn into_iter(self) -> Self::IntoIter {
        self.iter_mut()
    }
}

/// The words are the length and then the words of `N` elements; those beyond the length are zeros.
#[diagnostic::do_not_recommend]
impl<T: Plain, const N: usize> Plain for List<T, N> {
    const WORDS: usize = 1 + N * T::WORDS;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        self.length.store(out);
        self.iter().for_each(|element| element.store(out));
        (0..(N - self.length) * T::WORDS).for_each(|_| out(0));
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        let length = usize::load(next).min(N);
        List { length, items: <[T; N]>::load(next) }
    }
}
