//! The companions of nalgebra's views: what is read is a copy, what is written is said as a call.

#![allow(missing_docs)]

use bessemer_ir::tree;
use nalgebra::{SMatrix, SVector};

use super::builder::{Builder, Callee};
use super::builtin::markers;
use super::numbers::FromBuiltin;
use super::slot::{Called, Value};
use crate::element::Element;
use crate::linear::views;

markers! {
    Owned: Owned;
}

/// The result of a companion that is a function of the DSL: it names no reference.
macro_rules! told {
    (use<$($kept:ident),*> $result:ty) => { Called<impl Callee + use<$($kept),*>, $result> };
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

/// Parts of matrices, read and written.
pub trait ViewBuiltins<T: Element, const R: usize, const C: usize>: Sized {
    fn __b_into_owned(self) -> Called<Owned, Self> {
        unreachable!()
    }
    fn __b_clone_owned(&self) -> Called<Owned, Self> {
        unreachable!()
    }
    fn __b_row(&self, row: usize) -> told!(use<Self, T, R, C> SMatrix<T, 1, C>);
    fn __b_column(&self, column: usize) -> told!(use<Self, T, R, C> SVector<T, R>);
    fn __b_fixed_view<const ROWS: usize, const COLUMNS: usize>(
        &self,
        row: usize,
        column: usize,
    ) -> told!(use<Self, T, R, C, ROWS, COLUMNS> SMatrix<T, ROWS, COLUMNS>);
    fn __b_fixed_rows<const ROWS: usize>(
        &self,
        row: usize,
    ) -> told!(use<Self, T, R, C, ROWS> SMatrix<T, ROWS, C>);
    fn __b_fixed_columns<const COLUMNS: usize>(
        &self,
        column: usize,
    ) -> told!(use<Self, T, R, C, COLUMNS> SMatrix<T, R, COLUMNS>);
    fn __b_set_row(&mut self, row: usize, part: &SMatrix<T, 1, C>) -> told!(use<Self, T, R, C> ());
    fn __b_set_column(
        &mut self,
        column: usize,
        part: &SVector<T, R>,
    ) -> told!(use<Self, T, R, C> ());
    fn __b_set_fixed_view<const ROWS: usize, const COLUMNS: usize>(
        &mut self,
        row: usize,
        column: usize,
        part: &SMatrix<T, ROWS, COLUMNS>,
    ) -> told!(use<Self, T, R, C, ROWS, COLUMNS> ());
    fn __b_set_fixed_rows<const ROWS: usize>(
        &mut self,
        row: usize,
        part: &SMatrix<T, ROWS, C>,
    ) -> told!(use<Self, T, R, C, ROWS> ());
    fn __b_set_fixed_columns<const COLUMNS: usize>(
        &mut self,
        column: usize,
        part: &SMatrix<T, R, COLUMNS>,
    ) -> told!(use<Self, T, R, C, COLUMNS> ());
}

impl<T: Element, const R: usize, const C: usize> ViewBuiltins<T, R, C> for SMatrix<T, R, C> {
    fn __b_row(&self, row: usize) -> told!(use<T, R, C> SMatrix<T, 1, C>) {
        views::row::__call(self, row)
    }
    fn __b_column(&self, column: usize) -> told!(use<T, R, C> SVector<T, R>) {
        views::column::__call(self, column)
    }
    fn __b_fixed_view<const ROWS: usize, const COLUMNS: usize>(
        &self,
        row: usize,
        column: usize,
    ) -> told!(use<T, R, C, ROWS, COLUMNS> SMatrix<T, ROWS, COLUMNS>) {
        views::fixed_view::__call(self, row, column)
    }
    fn __b_fixed_rows<const ROWS: usize>(
        &self,
        row: usize,
    ) -> told!(use<T, R, C, ROWS> SMatrix<T, ROWS, C>) {
        views::fixed_rows::__call(self, row)
    }
    fn __b_fixed_columns<const COLUMNS: usize>(
        &self,
        column: usize,
    ) -> told!(use<T, R, C, COLUMNS> SMatrix<T, R, COLUMNS>) {
        views::fixed_columns::__call(self, column)
    }
    fn __b_set_row(&mut self, row: usize, part: &SMatrix<T, 1, C>) -> told!(use<T, R, C> ()) {
        views::set_row::__call(self, row, part)
    }
    fn __b_set_column(&mut self, column: usize, part: &SVector<T, R>) -> told!(use<T, R, C> ()) {
        views::set_column::__call(self, column, part)
    }
    fn __b_set_fixed_view<const ROWS: usize, const COLUMNS: usize>(
        &mut self,
        row: usize,
        column: usize,
        part: &SMatrix<T, ROWS, COLUMNS>,
    ) -> told!(use<T, R, C, ROWS, COLUMNS> ()) {
        views::set_fixed_view::__call(self, row, column, part)
    }
    fn __b_set_fixed_rows<const ROWS: usize>(
        &mut self,
        row: usize,
        part: &SMatrix<T, ROWS, C>,
    ) -> told!(use<T, R, C, ROWS> ()) {
        views::set_fixed_rows::__call(self, row, part)
    }
    fn __b_set_fixed_columns<const COLUMNS: usize>(
        &mut self,
        column: usize,
        part: &SMatrix<T, R, COLUMNS>,
    ) -> told!(use<T, R, C, COLUMNS> ()) {
        views::set_fixed_columns::__call(self, column, part)
    }
}
