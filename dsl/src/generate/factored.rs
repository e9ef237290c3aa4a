//! The companions of nalgebra's decompositions: what is nalgebra's type in the simulation is a struct of
//! the DSL in the C.

#![allow(missing_docs)]

use bessemer_ir::tree::Ty;
use nalgebra::{Cholesky, Const, DimMin, LU, QR, SMatrix, SVector, UDU};

use super::builder::{Builder, Callee};
use super::builtin::companions;
use super::slot::{Called, DslType, Seen, stands};
use crate::linear::factored::cholesky::CholeskyFactor;
use crate::linear::factored::lu::Lu;
use crate::linear::factored::qr::Qr;
use crate::linear::factored::udu::Udu;
use crate::linear::factored::{cholesky, lu, qr, udu};
use crate::math::Real;

/// The DSL's struct in place of nalgebra's value, lent to be read or to be changed. No companion is ever run.
#[allow(clippy::mut_from_ref)]
fn held<N, D>(_: &N) -> &mut D {
    unreachable!("a witness copy is never run")
}

/// nalgebra's value in place of the DSL's struct.
fn gives<M, D, N>(_: Called<M, D>) -> Called<M, N> {
    unreachable!("a witness copy is never run")
}

/// What a companion returns that names a method of such a struct: its marker has no name here.
macro_rules! told {
    ([$($kept:ident),*] $(+ $more:ident)* => $result:ty) => {
        Called<impl Callee + use<$($kept),* $(, $more)*>, $result>
    };
}

stands! {
    [T: Real, const N: usize] LU<T, Const<N>, Const<N>>
        where Const<N>: DimMin<Const<N>, Output = Const<N>> => Lu<T, N>;
    [T: Real, const R: usize, const C: usize] QR<T, Const<R>, Const<C>>
        where Const<R>: DimMin<Const<C>, Output = Const<C>> => Qr<T, R, C>;
    [T: Real, const N: usize] Cholesky<T, Const<N>> => CholeskyFactor<T, N>;
    [T: Real, const N: usize] UDU<T, Const<N>> => Udu<T, N>;
}

companions! {
    /// Factors of square matrices.
    impl[T: Real, const N: usize] LuBuiltins<T, N> for SMatrix<T, N, N>
        where Const<N>: DimMin<Const<N>, Output = Const<N>>
    {
        fn __b_lu(self) -> LU<T, Const<N>, Const<N>> = [lu::__function_factored<T, N>];
    }
    /// Factors of matrices with no more columns than rows.
    impl[T: Real, const R: usize, const C: usize] QrBuiltins<T, R, C> for SMatrix<T, R, C>
        where Const<R>: DimMin<Const<C>, Output = Const<C>>
    {
        fn __b_qr(self) -> QR<T, Const<R>, Const<C>> = [qr::__function_factored<T, R, C>];
    }
    /// Factors of symmetric matrices.
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

/// A trait with the companions of the methods of one of nalgebra's types.
macro_rules! methods {
    (
        $(#[$doc:meta])*
        $trait:ident<$($n:ident),*> $in_trait:tt for $native:ty, $in_type:tt
        $(where [$($bound:tt)+])?
        {$(
            fn $name:ident $(<$($k:ident),*>)? ($($parameters:tt)*) -> $result:ty $body:block
        )*}
    ) => {
        $(#[$doc])*
        pub trait $trait<T: Real, $(const $n: usize),*>: Sized {$(
            fn $name $(<$(const $k: usize),*>)? ($($parameters)*)
                -> told!($in_trait $($(+ $k)*)? => $result);
        )*}

        impl<T: Real, $(const $n: usize),*> $trait<T, $($n),*> for $native $(where $($bound)+)? {$(
            fn $name $(<$(const $k: usize),*>)? ($($parameters)*)
                -> told!($in_type $($(+ $k)*)? => $result)
            $body
        )*}
    };
}
methods! {
    /// Methods of LU.
    LuMethods<N> [Self, T, N] for LU<T, Const<N>, Const<N>>, [T, N]
    where [Const<N>: DimMin<Const<N>, Output = Const<N>>]
    {
        fn __b_new(a: SMatrix<T, N, N>) -> Self { gives(lu::factored::__call(&a)) }
        fn __b_solve<K>(&self, b: &SMatrix<T, N, K>) -> Option<SMatrix<T, N, K>> {
            held::<_, Lu<T, N>>(self).__b_solve(b)
        }
        fn __b_solve_mut<K>(&self, b: &mut SMatrix<T, N, K>) -> bool {
            held::<_, Lu<T, N>>(self).__b_solve_mut(b)
        }
        fn __b_try_inverse(&self) -> Option<SMatrix<T, N, N>> {
            held::<_, Lu<T, N>>(self).__b_try_inverse()
        }
        fn __b_is_invertible(&self) -> bool { held::<_, Lu<T, N>>(self).__b_is_invertible() }
        fn __b_determinant(&self) -> T { held::<_, Lu<T, N>>(self).__b_determinant() }
        fn __b_l(&self) -> SMatrix<T, N, N> { held::<_, Lu<T, N>>(self).__b_l() }
        fn __b_l_unpack(self) -> SMatrix<T, N, N> { held::<_, Lu<T, N>>(&self).__b_l() }
        fn __b_u(&self) -> SMatrix<T, N, N> { held::<_, Lu<T, N>>(self).__b_u() }
    }
}

methods! {
    /// Methods of Cholesky's factor.
    CholeskyMethods<N> [Self, T, N] for Cholesky<T, Const<N>>, [T, N] {
        fn __b_new(a: SMatrix<T, N, N>) -> Option<Self> { gives(cholesky::factored::__call(&a)) }
        fn __b_solve<K>(&self, b: &SMatrix<T, N, K>) -> SMatrix<T, N, K> {
            held::<_, CholeskyFactor<T, N>>(self).__b_solve(b)
        }
        fn __b_solve_mut<K>(&self, b: &mut SMatrix<T, N, K>) -> () {
            held::<_, CholeskyFactor<T, N>>(self).__b_solve_mut(b)
        }
        fn __b_inverse(&self) -> SMatrix<T, N, N> {
            held::<_, CholeskyFactor<T, N>>(self).__b_inverse()
        }
        fn __b_l(&self) -> SMatrix<T, N, N> { held::<_, CholeskyFactor<T, N>>(self).__b_l() }
        fn __b_unpack(self) -> SMatrix<T, N, N> { held::<_, CholeskyFactor<T, N>>(&self).__b_l() }
        fn __b_unpack_dirty(self) -> SMatrix<T, N, N> {
            held::<_, CholeskyFactor<T, N>>(&self).__b_unpack_dirty()
        }
        fn __b_determinant(&self) -> T { held::<_, CholeskyFactor<T, N>>(self).__b_determinant() }
        fn __b_rank_one_update(&mut self, x: &SVector<T, N>, sigma: T) -> () {
            held::<_, CholeskyFactor<T, N>>(self).__b_rank_one_update(x, sigma)
        }
    }
}

methods! {
    /// Methods of QR.
    QrMethods<R, C> [Self, T, R, C] for QR<T, Const<R>, Const<C>>, [T, R, C]
    where [Const<R>: DimMin<Const<C>, Output = Const<C>>]
    {
        fn __b_new(a: SMatrix<T, R, C>) -> Self { gives(qr::factored::__call(&a)) }
        fn __b_q(&self) -> SMatrix<T, R, C> { held::<_, Qr<T, R, C>>(self).__b_q() }
        fn __b_r(&self) -> SMatrix<T, C, C> { held::<_, Qr<T, R, C>>(self).__b_r() }
        fn __b_unpack_r(self) -> SMatrix<T, C, C> { held::<_, Qr<T, R, C>>(&self).__b_r() }
        fn __b_q_tr_mul<K>(&self, b: &mut SMatrix<T, R, K>) -> () {
            held::<_, Qr<T, R, C>>(self).__b_q_tr_mul(b)
        }
    }
}

methods! {
    /// Methods of U D Uᵀ.
    UduMethods<N> [Self, T, N] for UDU<T, Const<N>>, [T, N] {
        fn __b_new(a: SMatrix<T, N, N>) -> Option<Self> { gives(udu::factored::__call(&a)) }
        fn __b_d_matrix(&self) -> SMatrix<T, N, N> { held::<_, Udu<T, N>>(self).__b_d_matrix() }
    }
}
