//! The companions of nalgebra's methods whose result is of another size: that size is a projection of
//! nalgebra's, so the function of the DSL is chosen by the type of the result.

#![allow(missing_docs, unreachable_code, clippy::diverging_sub_expression)]

use core::marker::PhantomData;

use bessemer_ir::tree;
use nalgebra::allocator::Allocator;
use nalgebra::{
    Const, DefaultAllocator, DimAdd, DimDiff, DimMul, DimProd, DimSub, DimSum, OMatrix, SMatrix,
    SVector, U1,
};

use super::builder::{Builder, Callee};
use super::matrices::told;
use super::slot::Called;
use crate::linear::matrix_resize;
use crate::math::Real;

/// The callee of a companion that is not run.
fn told_by<M: Callee, R>(_: impl FnOnce() -> Called<M, R>, cx: &mut Builder) -> tree::Callee {
    M::callee(cx)
}

macro_rules! resized {
    ($($(#[$doc:meta])* $marker:ident<$($n:ident),*> $method:ident
        => $function:ident<$($argument:ident),*>($($unused:tt)*);)*) => {
        /// A matrix as a result of known size.
        pub trait Resized<T> {$(
            fn $method<$(const $n: usize),*>(cx: &mut Builder) -> tree::Callee;
        )*}

        impl<T: Real, const ROWS: usize, const COLUMNS: usize> Resized<T>
            for SMatrix<T, ROWS, COLUMNS>
        {$(
            fn $method<$(const $n: usize),*>(cx: &mut Builder) -> tree::Callee {
                told_by(|| matrix_resize::$function::__call::<T, $($argument),*>($($unused)*), cx)
            }
        )*}

        $(
            $(#[$doc])*
            pub struct $marker<T, M, $(const $n: usize),*>(PhantomData<fn() -> (T, M)>);

            impl<T, M: Resized<T>, $(const $n: usize),*> Callee for $marker<T, M, $($n),*> {
                fn callee(cx: &mut Builder) -> tree::Callee {
                    M::$method::<$($n),*>(cx)
                }
            }
        )*
    };
}

resized! {
    /// `kronecker`.
    Kronecker<R, C, R2, C2> kronecker
        => kronecker<R, C, R2, C2, ROWS, COLUMNS>(unreachable!(), unreachable!());
    /// `push`.
    Push<N> push => push<N, ROWS>(unreachable!(), unreachable!());
    /// `insert_row`.
    InsertRow<R, C> insert_row
        => insert_row<R, C, ROWS>(unreachable!(), unreachable!(), unreachable!());
    /// `insert_column`.
    InsertColumn<R, C> insert_column
        => insert_column<R, C, COLUMNS>(unreachable!(), unreachable!(), unreachable!());
    /// `remove_row`.
    RemoveRow<R, C> remove_row => remove_row<R, C, ROWS>(unreachable!(), unreachable!());
    /// `remove_column`.
    RemoveColumn<R, C> remove_column
        => remove_column<R, C, COLUMNS>(unreachable!(), unreachable!());
}

type Product<T, const R: usize, const C: usize, const R2: usize, const C2: usize> =
    OMatrix<T, DimProd<Const<R>, Const<R2>>, DimProd<Const<C>, Const<C2>>>;
type Larger<T, const R: usize, const C: usize> = OMatrix<T, DimSum<Const<R>, U1>, Const<C>>;
type Wider<T, const R: usize, const C: usize> = OMatrix<T, Const<R>, DimSum<Const<C>, U1>>;
type Smaller<T, const R: usize, const C: usize> = OMatrix<T, DimDiff<Const<R>, U1>, Const<C>>;
type Narrower<T, const R: usize, const C: usize> = OMatrix<T, Const<R>, DimDiff<Const<C>, U1>>;

/// Methods of matrices whose result is of another size.
pub trait ResizedBuiltins<T: Real, const R: usize, const C: usize>: Sized {
    fn __b_kronecker<const R2: usize, const C2: usize>(
        &self,
        _b: &SMatrix<T, R2, C2>,
    ) -> Called<Kronecker<T, Product<T, R, C, R2, C2>, R, C, R2, C2>, Product<T, R, C, R2, C2>>
    where
        Const<R>: DimMul<Const<R2>>,
        Const<C>: DimMul<Const<C2>>,
        DefaultAllocator: Allocator<DimProd<Const<R>, Const<R2>>, DimProd<Const<C>, Const<C2>>>,
    {
        unreachable!()
    }
    fn __b_insert_row(
        self,
        _at: usize,
        _value: T,
    ) -> Called<InsertRow<T, Larger<T, R, C>, R, C>, Larger<T, R, C>>
    where
        Const<R>: DimAdd<U1>,
        DefaultAllocator: Allocator<DimSum<Const<R>, U1>, Const<C>>,
    {
        unreachable!()
    }
    fn __b_insert_column(
        self,
        _at: usize,
        _value: T,
    ) -> Called<InsertColumn<T, Wider<T, R, C>, R, C>, Wider<T, R, C>>
    where
        Const<C>: DimAdd<U1>,
        DefaultAllocator: Allocator<Const<R>, DimSum<Const<C>, U1>>,
    {
        unreachable!()
    }
    fn __b_remove_row(
        self,
        _at: usize,
    ) -> Called<RemoveRow<T, Smaller<T, R, C>, R, C>, Smaller<T, R, C>>
    where
        Const<R>: DimSub<U1>,
        DefaultAllocator: Allocator<DimDiff<Const<R>, U1>, Const<C>>,
    {
        unreachable!()
    }
    fn __b_remove_column(
        self,
        _at: usize,
    ) -> Called<RemoveColumn<T, Narrower<T, R, C>, R, C>, Narrower<T, R, C>>
    where
        Const<C>: DimSub<U1>,
        DefaultAllocator: Allocator<Const<R>, DimDiff<Const<C>, U1>>,
    {
        unreachable!()
    }
    fn __b_fixed_resize<const R2: usize, const C2: usize>(
        self,
        value: T,
    ) -> told!([Self, T, R, C] + R2 + C2 => SMatrix<T, R2, C2>);
}

impl<T: Real, const R: usize, const C: usize> ResizedBuiltins<T, R, C> for SMatrix<T, R, C> {
    fn __b_fixed_resize<const R2: usize, const C2: usize>(
        self,
        value: T,
    ) -> told!([T, R, C] + R2 + C2 => SMatrix<T, R2, C2>) {
        matrix_resize::fixed_resize::__call(&self, value)
    }
}

/// The same of vectors.
pub trait PushBuiltin<T: Real, const N: usize>: Sized {
    fn __b_push(&self, _element: T) -> Called<Push<T, Larger<T, N, 1>, N>, Larger<T, N, 1>>
    where
        Const<N>: DimAdd<U1>,
        DefaultAllocator: Allocator<DimSum<Const<N>, U1>>,
    {
        unreachable!()
    }
}

impl<T: Real, const N: usize> PushBuiltin<T, N> for SVector<T, N> {}
