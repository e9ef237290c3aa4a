//! The companions of nalgebra's methods whose result is of another size: that size is a projection of
//! nalgebra's, so the function of the DSL is chosen by the type of the result.

#![allow(missing_docs)]

use core::marker::PhantomData;

use bessemer_ir::tree;
use nalgebra::allocator::Allocator;
use nalgebra::{
    Const, DefaultAllocator, DimAdd, DimDiff, DimMul, DimProd, DimSub, DimSum, OMatrix, SMatrix,
    SVector, U1,
};

use super::builder::{Builder, Callee};
use super::builtin::companions;
use super::slot::Called;
use crate::linear::matrix_resize;
use crate::math::Real;

macro_rules! resized {
    ($($(#[$doc:meta])* $marker:ident<$($n:ident),*> $method:ident => $function:ident<$($argument:ident),*>;)*) => {
        /// A matrix as a result of known size.
        pub trait Resized<T> {$(
            fn $method<$(const $n: usize),*>(cx: &mut Builder) -> tree::Callee;
        )*}

        impl<T: Real, const ROWS: usize, const COLUMNS: usize> Resized<T>
            for SMatrix<T, ROWS, COLUMNS>
        {$(
            fn $method<$(const $n: usize),*>(cx: &mut Builder) -> tree::Callee {
                matrix_resize::$function::<T, $($argument),*>::callee(cx)
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
    Kronecker<R, C, R2, C2> kronecker => __function_kronecker<R, C, R2, C2, ROWS, COLUMNS>;
    /// `push`.
    Push<N> push => __function_push<N, ROWS>;
    /// `insert_row`.
    InsertRow<R, C> insert_row => __function_insert_row<R, C, ROWS>;
    /// `insert_column`.
    InsertColumn<R, C> insert_column => __function_insert_column<R, C, COLUMNS>;
    /// `remove_row`.
    RemoveRow<R, C> remove_row => __function_remove_row<R, C, ROWS>;
    /// `remove_column`.
    RemoveColumn<R, C> remove_column => __function_remove_column<R, C, COLUMNS>;
}

type Product<T, const R: usize, const C: usize, const R2: usize, const C2: usize> =
    OMatrix<T, DimProd<Const<R>, Const<R2>>, DimProd<Const<C>, Const<C2>>>;
type Larger<T, const R: usize, const C: usize> = OMatrix<T, DimSum<Const<R>, U1>, Const<C>>;
type Wider<T, const R: usize, const C: usize> = OMatrix<T, Const<R>, DimSum<Const<C>, U1>>;
type Smaller<T, const R: usize, const C: usize> = OMatrix<T, DimDiff<Const<R>, U1>, Const<C>>;
type Narrower<T, const R: usize, const C: usize> = OMatrix<T, Const<R>, DimDiff<Const<C>, U1>>;

companions! {
    /// Methods of matrices whose result is of another size.
    impl[T: Real, const R: usize, const C: usize] ResizedBuiltins<T, R, C> for SMatrix<T, R, C> {
        fn __b_kronecker[const R2: usize, const C2: usize](&self, _b: &SMatrix<T, R2, C2>) -> Product<T, R, C, R2, C2>
            where Const<R>: DimMul<Const<R2>>, Const<C>: DimMul<Const<C2>>,
                DefaultAllocator: Allocator<DimProd<Const<R>, Const<R2>>, DimProd<Const<C>, Const<C2>>>
            = [Kronecker<T, Product<T, R, C, R2, C2>, R, C, R2, C2>];
        fn __b_insert_row(self, _at: usize, _value: T) -> Larger<T, R, C>
            where Const<R>: DimAdd<U1>, DefaultAllocator: Allocator<DimSum<Const<R>, U1>, Const<C>>
            = [InsertRow<T, Larger<T, R, C>, R, C>];
        fn __b_insert_column(self, _at: usize, _value: T) -> Wider<T, R, C>
            where Const<C>: DimAdd<U1>, DefaultAllocator: Allocator<Const<R>, DimSum<Const<C>, U1>>
            = [InsertColumn<T, Wider<T, R, C>, R, C>];
        fn __b_remove_row(self, _at: usize) -> Smaller<T, R, C>
            where Const<R>: DimSub<U1>, DefaultAllocator: Allocator<DimDiff<Const<R>, U1>, Const<C>>
            = [RemoveRow<T, Smaller<T, R, C>, R, C>];
        fn __b_remove_column(self, _at: usize) -> Narrower<T, R, C>
            where Const<C>: DimSub<U1>, DefaultAllocator: Allocator<Const<R>, DimDiff<Const<C>, U1>>
            = [RemoveColumn<T, Narrower<T, R, C>, R, C>];
    }
    /// The same of vectors.
    impl[T: Real, const N: usize] PushBuiltin<T, N> for SVector<T, N> {
        fn __b_push(&self, _element: T) -> Larger<T, N, 1>
            where Const<N>: DimAdd<U1>, DefaultAllocator: Allocator<DimSum<Const<N>, U1>>
            = [Push<T, Larger<T, N, 1>, N>];
    }
}
