//! The companions of nalgebra's views: what is read is a copy, what is written is said as a call.

#![allow(missing_docs)]

use bessemer_ir::tree::{self, MatrixMethod, MatrixPart};
use nalgebra::{SMatrix, SVector};

use core::marker::PhantomData;

use super::builder::{Builder, Callee};
use super::builtin::{markers, signatures};
use super::iterator::Items;
use super::matrices::{companions, told};
use super::numbers::FromBuiltin;
use super::slot::{Called, Companion, Value};
use crate::element::Element;
use crate::linear::{lines, views};

markers! {
    Owned: Owned;
    RowsMut: Matrix(MatrixMethod::Part(MatrixPart::Rows));
    ColumnsMut: Matrix(MatrixMethod::Part(MatrixPart::Columns));
    BlockMut: Matrix(MatrixMethod::Part(MatrixPart::Block));
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
    }
}

/// Parts of matrices that are written: to rustc a value of the part's type, whose place the typifier knows.
pub trait WrittenViews<T, const R: usize, const C: usize>: Sized {
    signatures! {
        fn __b_row_mut(&mut self, _row: usize) -> Called<RowsMut, SMatrix<T, 1, C>>;
        fn __b_column_mut(&mut self, _column: usize) -> Called<ColumnsMut, SVector<T, R>>;
        fn __b_written_row(&mut self, _row: usize) -> Called<RowsMut, SMatrix<T, 1, C>>;
        fn __b_written_column(&mut self, _column: usize) -> Called<ColumnsMut, SVector<T, R>>;
    }
    fn __b_fixed_rows_mut<const M: usize>(
        &mut self,
        _row: usize,
    ) -> Called<RowsMut, SMatrix<T, M, C>> {
        unreachable!()
    }
    fn __b_fixed_columns_mut<const N: usize>(
        &mut self,
        _column: usize,
    ) -> Called<ColumnsMut, SMatrix<T, R, N>> {
        unreachable!()
    }
    fn __b_fixed_view_mut<const M: usize, const N: usize>(
        &mut self,
        _row: usize,
        _column: usize,
    ) -> Called<BlockMut, SMatrix<T, M, N>> {
        unreachable!()
    }
}

impl<T: Element, const R: usize, const C: usize> WrittenViews<T, R, C> for SMatrix<T, R, C> {}

/// The marker of a function that gives lines of a matrix.
macro_rules! gives_lines {
    ($($marker:ident: $function:ident([$($matrix:tt)+]) -> $line:ty;)*) => {$(
        #[doc = concat!("The marker of `", stringify!($function), "`.")]
        pub struct $marker<T, const R: usize, const C: usize>(PhantomData<T>);
        impl<T: Element, const R: usize, const C: usize> Callee for $marker<T, R, C> {
            fn callee(cx: &mut Builder) -> tree::Callee {
                let function = lines::$function::__call
                    as fn($($matrix)+ SMatrix<T, R, C>, fn($line)) -> _;
                Companion::callee(function, cx)
            }
        }
    )*};
}

gives_lines! {
    ColumnIter: column_iter([&'static]) -> SVector<T, R>;
    RowIter: row_iter([&'static]) -> SMatrix<T, 1, C>;
    ColumnIterMut: column_iter_mut([&'static mut]) -> SVector<T, R>;
    RowIterMut: row_iter_mut([&'static mut]) -> SMatrix<T, 1, C>;
}

/// The lines of a matrix, one after another.
pub trait LineBuiltins<T, const R: usize, const C: usize>: Sized {
    signatures! {
        fn __b_column_iter(&self) -> Called<ColumnIter<T, R, C>, Items<SVector<T, R>>>;
        fn __b_row_iter(&self) -> Called<RowIter<T, R, C>, Items<SMatrix<T, 1, C>>>;
        fn __b_column_iter_mut(&mut self) -> Called<ColumnIterMut<T, R, C>, Items<SVector<T, R>>>;
        fn __b_row_iter_mut(&mut self) -> Called<RowIterMut<T, R, C>, Items<SMatrix<T, 1, C>>>;
    }
}

impl<T: Element, const R: usize, const C: usize> LineBuiltins<T, R, C> for SMatrix<T, R, C> {}
