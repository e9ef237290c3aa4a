//! Functions of the DSL that call a closure for each element of a matrix, by columns as in nalgebra.

use nalgebra::SMatrix;

use crate::element::Element;
use crate::library;

#[library(EachElementCompanions, expand)]
impl<T: Element, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// The values of `f` for the elements.
    pub fn map<U: Element, F: FnMut(T) -> U>(elements: &Self, mut f: F) -> SMatrix<U, R, C> {
        let mut mapped = SMatrix::<U, R, C>::from_element(U::ZERO);
        for (mapped, x) in mapped.iter_mut().zip(elements.iter()) {
            *mapped = f(*x);
        }
        mapped
    }

    /// The values of `f` for the elements of two matrices.
    pub fn zip_map<U: Element, V: Element, F: FnMut(T, U) -> V>(
        elements: &Self,
        others: &SMatrix<U, R, C>,
        mut f: F,
    ) -> SMatrix<V, R, C> {
        let mut mapped = SMatrix::<V, R, C>::from_element(V::ZERO);
        for ((mapped, x), y) in mapped.iter_mut().zip(elements.iter()).zip(others.iter()) {
            *mapped = f(*x, *y);
        }
        mapped
    }

    /// The values of `f` for each row, column and element.
    pub fn map_with_location<U: Element, F: FnMut(usize, usize, T) -> U>(
        elements: &Self,
        mut f: F,
    ) -> SMatrix<U, R, C> {
        let mut mapped = SMatrix::<U, R, C>::from_element(U::ZERO);
        for column in 0..C {
            for row in 0..R {
                mapped[(row, column)] = f(row, column, elements[(row, column)]);
            }
        }
        mapped
    }

    /// The values of `f` for each row and column.
    pub fn from_fn<F: FnMut(usize, usize) -> T>(mut f: F) -> Self {
        let mut made = SMatrix::<T, R, C>::from_element(T::ZERO);
        for column in 0..C {
            for row in 0..R {
                made[(row, column)] = f(row, column);
            }
        }
        made
    }

    /// Calls `f` with each element, which it may change.
    pub fn apply<F: FnMut(&mut T)>(elements: &mut Self, mut f: F) {
        for x in elements.iter_mut() {
            f(x);
        }
    }

    /// Calls `f` with each element, which it may change, and the other matrix's element at its position.
    pub fn zip_apply<U: Element, F: FnMut(&mut T, U)>(
        elements: &mut Self,
        others: &SMatrix<U, R, C>,
        mut f: F,
    ) {
        for (x, y) in elements.iter_mut().zip(others.iter()) {
            f(x, *y);
        }
    }

    /// Folds the elements with `f`.
    pub fn fold<A, F: FnMut(A, T) -> A>(elements: &Self, start: A, mut f: F) -> A {
        let mut gathered = start;
        for x in elements.iter() {
            gathered = f(gathered, *x);
        }
        gathered
    }

    /// Folds the elements of two matrices with `f`.
    pub fn zip_fold<U: Element, A, F: FnMut(A, T, U) -> A>(
        elements: &Self,
        others: &SMatrix<U, R, C>,
        start: A,
        mut f: F,
    ) -> A {
        let mut gathered = start;
        for (x, y) in elements.iter().zip(others.iter()) {
            gathered = f(gathered, *x, *y);
        }
        gathered
    }
}
