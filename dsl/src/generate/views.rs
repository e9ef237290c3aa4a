//! The companions of nalgebra's views: what is read is a copy, what is written is said as a call.

#![allow(missing_docs)]

use bessemer_ir::tree;
use nalgebra::{SMatrix, SVector};

use super::builder::{Builder, Callee};
use super::builtin::{markers, signatures};
use super::matrices::{companions, told};
use super::numbers::FromBuiltin;
use super::slot::{Called, Value};
use crate::element::Element;
use crate::linear::views;

markers! {
    Owned: Owned;
}

/// `x.clone()` of what copies itself; of a reference it would be one.
pub trait CopyBuiltin: Copy + Value {
    fn __b_clone(&self) -> Called<Owned, Self> {
        unreachable!()
    }
}

impl<T: Copy + Value> CopyBuiltin for T {}

/// `view.into()`: what is read is a copy already.
impl<T: Element, const R: usize, const C: usize> FromBuiltin<SMatrix<T, R, C>>
    for SMatrix<T, R, C>
{
    type Marker = Owned;
}

/// The same of a view.
pub trait OwnedBuiltins: Sized {
    signatures! {
        fn __b_into_owned(self) -> Called<Owned, Self>;
        fn __b_clone_owned(&self) -> Called<Owned, Self>;
    }
}

impl<T: Element, const R: usize, const C: usize> OwnedBuiltins for SMatrix<T, R, C> {}

companions! {
    /// Parts of matrices, read and written.
    ViewBuiltins<R, C>: Element [Self, T, R, C] for SMatrix<T, R, C>, [T, R, C] {
        fn __b_row(&self, row: usize) -> SMatrix<T, 1, C> { views::row(self, row) }
        fn __b_column(&self, column: usize) -> SVector<T, R> { views::column(self, column) }
        fn __b_fixed_view<M, N>(&self, row: usize, column: usize) -> SMatrix<T, M, N> {
            views::fixed_view(self, row, column)
        }
        fn __b_fixed_rows<M>(&self, row: usize) -> SMatrix<T, M, C> { views::fixed_rows(self, row) }
        fn __b_fixed_columns<N>(&self, column: usize) -> SMatrix<T, R, N> {
            views::fixed_columns(self, column)
        }
        fn __b_set_row(&mut self, row: usize, part: &SMatrix<T, 1, C>) -> () {
            views::set_row(self, row, part)
        }
        fn __b_set_column(&mut self, column: usize, part: &SVector<T, R>) -> () {
            views::set_column(self, column, part)
        }
        fn __b_set_fixed_view<M, N>(
            &mut self, row: usize, column: usize, part: &SMatrix<T, M, N>
        ) -> () {
            views::set_fixed_view(self, row, column, part)
        }
        fn __b_set_fixed_rows<M>(&mut self, row: usize, part: &SMatrix<T, M, C>) -> () {
            views::set_fixed_rows(self, row, part)
        }
        fn __b_set_fixed_columns<N>(&mut self, column: usize, part: &SMatrix<T, R, N>) -> () {
            views::set_fixed_columns(self, column, part)
        }
    }
}
