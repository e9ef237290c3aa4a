//! The companions of nalgebra's methods that take a closure for each element of a matrix: functions of the DSL in the C.

#![allow(missing_docs)]

use nalgebra::SMatrix;

use super::builder::Callee;
use super::matrices::{companions, told};
use super::slot::{Called, Value};
use crate::element::Element;
use crate::linear::each_element;

companions! {
    /// Methods of matrices that take a closure.
    EachElement<R, C>: Element [Self, T, R, C] for SMatrix<T, R, C>, [T, R, C] {
        fn __b_map[U: (Element), F: (FnMut(T) -> U)](&self, f: F) -> SMatrix<U, R, C> {
            each_element::map(self, f)
        }
        fn __b_zip_map[U: (Element), V: (Element), F: (FnMut(T, U) -> V)](
            &self, other: &SMatrix<U, R, C>, f: F
        ) -> SMatrix<V, R, C> {
            each_element::zip_map(self, other, f)
        }
        fn __b_map_with_location[U: (Element), F: (FnMut(usize, usize, T) -> U)](
            &self, f: F
        ) -> SMatrix<U, R, C> {
            each_element::map_with_location(self, f)
        }
        fn __b_from_fn[F: (FnMut(usize, usize) -> T)](f: F) -> Self { each_element::from_fn(f) }
        fn __b_apply[F: (FnMut(&mut T))](&mut self, f: F) -> () { each_element::apply(self, f) }
        fn __b_zip_apply[U: (Element), F: (FnMut(&mut T, U))](
            &mut self, other: &SMatrix<U, R, C>, f: F
        ) -> () {
            each_element::zip_apply(self, other, f)
        }
        fn __b_fold[A: (Value), F: (FnMut(A, T) -> A)](&self, start: A, f: F) -> A {
            each_element::fold(self, start, f)
        }
        fn __b_zip_fold[U: (Element), A: (Value), F: (FnMut(A, T, U) -> A)](
            &self, other: &SMatrix<U, R, C>, start: A, f: F
        ) -> A {
            each_element::zip_fold(self, other, start, f)
        }
    }
}
