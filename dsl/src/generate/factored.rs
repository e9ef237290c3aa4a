//! Companions of nalgebra's decompositions. A decomposition is nalgebra's type in the simulation, and a struct of the
//! DSL in the C.

#![allow(missing_docs)]

use bessemer_tree::Ty;
use nalgebra::{Cholesky, Const, DimMin, LU, QR, SMatrix, SVector, UDU};

use super::builder::{Builder, Callee};
use super::companions::companions;
use super::handed::CompanionOf;
use super::slot::{Called, DslType, Seen, stands};
use crate::linear::factored::cholesky::CholeskyFactor;
use crate::linear::factored::lu::Lu;
use crate::linear::factored::qr::Qr;
use crate::linear::factored::udu::Udu;
use crate::linear::factored::{cholesky, lu, qr, udu};
use crate::math::Real;

stands! {
    [T: Real, const N: usize] LU<T, Const<N>, Const<N>>
        where Const<N>: DimMin<Const<N>, Output = Const<N>> => Lu<T, N>;
    [T: Real, const R: usize, const C: usize] QR<T, Const<R>, Const<C>>
        where Const<R>: DimMin<Const<C>, Output = Const<C>> => Qr<T, R, C>;
    [T: Real, const N: usize] Cholesky<T, Const<N>> => CholeskyFactor<T, N>;
    [T: Real, const N: usize] UDU<T, Const<N>> => Udu<T, N>;
}

companions! {
    pub mod traits[];
    /// Companions of decompositions of square matrices.
    impl[T: Real, const N: usize] LuBuiltins<T, N> for SMatrix<T, N, N>
        where Const<N>: DimMin<Const<N>, Output = Const<N>>
    {
        fn __b_lu(self) -> LU<T, Const<N>, Const<N>> = [lu::__function_factored<T, N>];
    }
    /// Companions of decompositions of matrices with at most as many columns as rows.
    impl[T: Real, const R: usize, const C: usize] QrBuiltins<T, R, C> for SMatrix<T, R, C>
        where Const<R>: DimMin<Const<C>, Output = Const<C>>
    {
        fn __b_qr(self) -> QR<T, Const<R>, Const<C>> = [qr::__function_factored<T, R, C>];
    }
    /// Companions of decompositions of symmetric matrices.
    impl[T: Real, const N: usize] SymmetricBuiltins<T, N> for SMatrix<T, N, N> {
        fn __b_cholesky(self) -> Option<Cholesky<T, Const<N>>> = [cholesky::__function_factored<T, N>];
        fn __b_udu(self) -> Option<UDU<T, Const<N>>> = [udu::__function_factored<T, N>];
    }
    /// Methods of QR of square matrices.
    impl[T: Real, const N: usize] SquareQrMethods<T, N> for QR<T, Const<N>, Const<N>>
        where Const<N>: DimMin<Const<N>, Output = Const<N>>
    {
        fn __b_solve[const K: usize](&self, _b: &SMatrix<T, N, K>) -> Option<SMatrix<T, N, K>>
            = [qr::__function_solve<T, N, K>];
        fn __b_solve_mut[const K: usize](&self, _b: &mut SMatrix<T, N, K>) -> bool = [qr::__function_solve_mut<T, N, K>];
        fn __b_try_inverse(&self) -> Option<SMatrix<T, N, N>> = [qr::__function_try_inverse<T, N>];
        fn __b_is_invertible(&self) -> bool = [qr::__function_is_invertible<T, N>];
    }
}

/// Returns the companion of another function or method, as one of nalgebra's type.
fn told<A, C: CompanionOf<A>, R>(_: C) -> Called<C::Marker, R> {
    unreachable!("a witness copy is never run")
}

/// Writes companions of the methods of one of nalgebra's types, for a method of the DSL's struct or a function. The
/// marker of a method has no name here, and contains no borrow of the companion.
macro_rules! methods {
    (
        $(#[$doc:meta])*
        impl[$($g:tt)*] $trait:ident $kept:tt for $native:ty $(where $place:ty: $bound:path)? {$(
            fn $name:ident $([$k:ident])? ($($parameters:tt)*) -> $result:ty = $companion:expr;
        )*}
    ) => {
        $(#[$doc])*
        pub trait $trait<$($g)*>: Sized {$(
            fn $name $(<const $k: usize>)? ($($parameters)*) -> methods!($kept $($k)? => $result) {
                told($companion)
            }
        )*}
        methods!(impl[$($g)*] $trait $kept for $native $(where $place: $bound)?);
    };
    ([$($kept:ident),*] $($k:ident)? => $result:ty) => {
        Called<impl Callee + use<Self, $($kept,)* $($k)?>, $result>
    };
    (impl[$($g:tt)*] $trait:ident [$($kept:ident),*] for $native:ty $(where $place:ty: $bound:path)?) => {
        impl<$($g)*> $trait<$($kept),*> for $native $(where $place: $bound)? {}
    };
}

methods! {
    /// Methods of an LU decomposition.
    impl[T: Real, const N: usize] LuMethods[T, N] for LU<T, Const<N>, Const<N>>
        where Const<N>: DimMin<Const<N>, Output = Const<N>>
    {
        fn __b_new(_a: SMatrix<T, N, N>) -> Self = lu::factored::__call::<T, N>;
        fn __b_solve[K](&self, _b: &SMatrix<T, N, K>) -> Option<SMatrix<T, N, K>> = Lu::<T, N>::__b_solve::<K>;
        fn __b_solve_mut[K](&self, _b: &mut SMatrix<T, N, K>) -> bool = Lu::<T, N>::__b_solve_mut::<K>;
        fn __b_try_inverse(&self) -> Option<SMatrix<T, N, N>> = Lu::<T, N>::__b_try_inverse;
        fn __b_is_invertible(&self) -> bool = Lu::<T, N>::__b_is_invertible;
        fn __b_determinant(&self) -> T = Lu::<T, N>::__b_determinant;
        fn __b_l(&self) -> SMatrix<T, N, N> = Lu::<T, N>::__b_l;
        fn __b_l_unpack(self) -> SMatrix<T, N, N> = Lu::<T, N>::__b_l;
        fn __b_u(&self) -> SMatrix<T, N, N> = Lu::<T, N>::__b_u;
    }
}

methods! {
    /// Methods of a Cholesky factor.
    impl[T: Real, const N: usize] CholeskyMethods[T, N] for Cholesky<T, Const<N>> {
        fn __b_new(_a: SMatrix<T, N, N>) -> Option<Self> = cholesky::factored::__call::<T, N>;
        fn __b_solve[K](&self, _b: &SMatrix<T, N, K>) -> SMatrix<T, N, K> = CholeskyFactor::<T, N>::__b_solve::<K>;
        fn __b_solve_mut[K](&self, _b: &mut SMatrix<T, N, K>) -> () = CholeskyFactor::<T, N>::__b_solve_mut::<K>;
        fn __b_inverse(&self) -> SMatrix<T, N, N> = CholeskyFactor::<T, N>::__b_inverse;
        fn __b_l(&self) -> SMatrix<T, N, N> = CholeskyFactor::<T, N>::__b_l;
        fn __b_unpack(self) -> SMatrix<T, N, N> = CholeskyFactor::<T, N>::__b_l;
        fn __b_unpack_dirty(self) -> SMatrix<T, N, N> = CholeskyFactor::<T, N>::__b_unpack_dirty;
        fn __b_determinant(&self) -> T = CholeskyFactor::<T, N>::__b_determinant;
        fn __b_rank_one_update(&mut self, _x: &SVector<T, N>, _sigma: T) -> ()
            = CholeskyFactor::<T, N>::__b_rank_one_update;
    }
}

methods! {
    /// Methods of a QR decomposition.
    impl[T: Real, const R: usize, const C: usize] QrMethods[T, R, C] for QR<T, Const<R>, Const<C>>
        where Const<R>: DimMin<Const<C>, Output = Const<C>>
    {
        fn __b_new(_a: SMatrix<T, R, C>) -> Self = qr::factored::__call::<T, R, C>;
        fn __b_q(&self) -> SMatrix<T, R, C> = Qr::<T, R, C>::__b_q;
        fn __b_r(&self) -> SMatrix<T, C, C> = Qr::<T, R, C>::__b_r;
        fn __b_unpack_r(self) -> SMatrix<T, C, C> = Qr::<T, R, C>::__b_r;
        fn __b_q_tr_mul[K](&self, _b: &mut SMatrix<T, R, K>) -> () = Qr::<T, R, C>::__b_q_tr_mul::<K>;
    }
}

methods! {
    /// Methods of a U D Uᵀ decomposition.
    impl[T: Real, const N: usize] UduMethods[T, N] for UDU<T, Const<N>> {
        fn __b_new(_p: SMatrix<T, N, N>) -> Option<Self> = udu::factored::__call::<T, N>;
        fn __b_d_matrix(&self) -> SMatrix<T, N, N> = Udu::<T, N>::__b_d_matrix;
    }
}
