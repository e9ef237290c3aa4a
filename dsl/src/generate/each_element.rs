//! The companions of nalgebra's methods that take a closure for each element of a matrix: functions of the DSL in the C.

#![allow(missing_docs)]

use nalgebra::SMatrix;

use super::builder::Callee;
use super::matrices::told;
use super::slot::{Called, Value};
use crate::element::Element;
use crate::linear::each_element;

/// Methods of matrices that take a closure.
pub trait EachElement<T, const R: usize, const C: usize>: Sized {
    fn __b_zip_map<U: Element, V: Element, F: FnMut(T, U) -> V>(
        &self,
        other: &SMatrix<U, R, C>,
        f: F,
    ) -> told!([Self, T, R, C] + U + V + F => SMatrix<V, R, C>);
    fn __b_map_with_location<U: Element, F: FnMut(usize, usize, T) -> U>(
        &self,
        f: F,
    ) -> told!([Self, T, R, C] + U + F => SMatrix<U, R, C>);
    fn __b_from_fn<F: FnMut(usize, usize) -> T>(f: F) -> told!([Self, T, R, C] + F => Self);
    fn __b_apply<F: FnMut(&mut T)>(&mut self, f: F) -> told!([Self, T, R, C] + F => ());
    fn __b_zip_apply<U: Element, F: FnMut(&mut T, U)>(
        &mut self,
        other: &SMatrix<U, R, C>,
        f: F,
    ) -> told!([Self, T, R, C] + U + F => ());
    fn __b_fold<A: Value, F: FnMut(A, T) -> A>(
        &self,
        start: A,
        f: F,
    ) -> told!([Self, T, R, C] + A + F => A);
    fn __b_zip_fold<U: Element, A: Value, F: FnMut(A, T, U) -> A>(
        &self,
        other: &SMatrix<U, R, C>,
        start: A,
        f: F,
    ) -> told!([Self, T, R, C] + U + A + F => A);
}

impl<T: Element, const R: usize, const C: usize> EachElement<T, R, C> for SMatrix<T, R, C> {
    fn __b_zip_map<U: Element, V: Element, F: FnMut(T, U) -> V>(
        &self,
        other: &SMatrix<U, R, C>,
        f: F,
    ) -> told!([T, R, C] + U + V + F => SMatrix<V, R, C>) {
        each_element::zip_map::__call(self, other, f)
    }
    fn __b_map_with_location<U: Element, F: FnMut(usize, usize, T) -> U>(
        &self,
        f: F,
    ) -> told!([T, R, C] + U + F => SMatrix<U, R, C>) {
        each_element::map_with_location::__call(self, f)
    }
    fn __b_from_fn<F: FnMut(usize, usize) -> T>(f: F) -> told!([T, R, C] + F => Self) {
        each_element::from_fn::__call(f)
    }
    fn __b_apply<F: FnMut(&mut T)>(&mut self, f: F) -> told!([T, R, C] + F => ()) {
        each_element::apply::__call(self, f)
    }
    fn __b_zip_apply<U: Element, F: FnMut(&mut T, U)>(
        &mut self,
        other: &SMatrix<U, R, C>,
        f: F,
    ) -> told!([T, R, C] + U + F => ()) {
        each_element::zip_apply::__call(self, other, f)
    }
    fn __b_fold<A: Value, F: FnMut(A, T) -> A>(
        &self,
        start: A,
        f: F,
    ) -> told!([T, R, C] + A + F => A) {
        each_element::fold::__call(self, start, f)
    }
    fn __b_zip_fold<U: Element, A: Value, F: FnMut(A, T, U) -> A>(
        &self,
        other: &SMatrix<U, R, C>,
        start: A,
        f: F,
    ) -> told!([T, R, C] + U + A + F => A) {
        each_element::zip_fold::__call(self, other, start, f)
    }
}
