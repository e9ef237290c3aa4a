//! The companions of nalgebra's methods that are functions of the DSL in the C.

#![allow(missing_docs)]

use core::borrow::Borrow;

use nalgebra::{SMatrix, SVector};

use super::builder::Callee;
use super::slot::Called;
use crate::element::{Element, Number};
use crate::linear::{
    blas, elementwise, inverse, matrix_edit, matrix_extremes, matrix_powers, matrix_statistics,
    norms, parts,
};
use crate::math::Real;

/// What such a companion returns: it names no reference.
macro_rules! told {
    ([$($kept:ident),*] $(+ $more:ident)* => $result:ty) => {
        Called<impl Callee + use<$($kept),* $(, $more)*>, $result>
    };
}

/// A trait with the companions of methods of a type that is generic over its element and its
/// dimensions; in brackets the names of these for the trait, then for the type. A method's own sizes
/// stand in angle brackets, its own types in square ones, with what they are in parentheses. Each body
/// says which function of the DSL is called; none is ever run.
macro_rules! companions {
    (
        $(#[$doc:meta])*
        $trait:ident<$($n:ident),*>: $bound:ident $in_trait:tt for $matrix:ty, $in_type:tt {$(
            fn $name:ident $(<$($k:ident),*>)? $([$($g:ident: ($($of:tt)*)),*])?
                ($($parameters:tt)*) -> $result:ty
            {
                $($function:ident)::+($($argument:expr),*)
            }
        )*}
    ) => {
        $(#[$doc])*
        pub trait $trait<T, $(const $n: usize),*>: Sized {$(
            fn $name<$($(const $k: usize,)*)? $($($g: $($of)*),*)?>($($parameters)*)
                -> told!($in_trait $($(+ $k)*)? $($(+ $g)*)? => $result);
        )*}

        impl<T: $bound, $(const $n: usize),*> $trait<T, $($n),*> for $matrix {$(
            fn $name<$($(const $k: usize,)*)? $($($g: $($of)*),*)?>($($parameters)*)
                -> told!($in_type $($(+ $k)*)? $($(+ $g)*)? => $result)
            {
                $($function)::+::__call($($argument),*)
            }
        )*}
    };
}

/// The same of any type: behind the type's name what the trait is generic over, behind `for` what the implementation is.
/// Each body calls the companion itself.
macro_rules! told_methods {
    (
        $(#[$doc:meta])*
        $trait:ident<$($p:ident),* $(; $($n:ident),*)?> $in_trait:tt $(: $sized:ident)?
        for ($($t:ident: ($($bound:tt)*)),*) $native:ty, $in_type:tt
        {$(
            fn $name:ident $([$($g:ident: ($($of:tt)*)),*])? ($($parameters:tt)*) -> $result:ty
            $body:block
        )*}
    ) => {
        $(#[$doc])*
        #[allow(missing_docs)]
        pub trait $trait<$($p,)* $($(const $n: usize),*)?> $(: $sized)? {$(
            fn $name $(<$($g: $($of)*),*>)? ($($parameters)*)
                -> told!($in_trait $($(+ $g)*)? => $result);
        )*}

        impl<$($t: $($bound)*,)* $($(const $n: usize),*)?> $trait<$($p,)* $($($n),*)?> for $native {$(
            fn $name $(<$($g: $($of)*),*>)? ($($parameters)*)
                -> told!($in_type $($(+ $g)*)? => $result)
            $body
        )*}
    };
}
pub(super) use {companions, told, told_methods};

companions! {
    /// Methods of matrices.
    PartBuiltins<R, C>: Real [Self, T, R, C] for SMatrix<T, R, C>, [T, R, C] {
        fn __b_amax(&self) -> T { matrix_extremes::amax(self) }
        fn __b_amin(&self) -> T { matrix_extremes::amin(self) }
        fn __b_camax(&self) -> T { matrix_extremes::amax(self) }
        fn __b_camin(&self) -> T { matrix_extremes::amin(self) }
        fn __b_iamax_full(&self) -> (usize, usize) { matrix_extremes::iamax_full(self) }
        fn __b_icamax_full(&self) -> (usize, usize) { matrix_extremes::iamax_full(self) }
        fn __b_inf(&self, other: &Self) -> Self { matrix_extremes::inf(self, other) }
        fn __b_sup(&self, other: &Self) -> Self { matrix_extremes::sup(self, other) }
        fn __b_inf_sup(&self, other: &Self) -> (Self, Self) { matrix_extremes::inf_sup(self, other) }

        fn __b_product(&self) -> T { matrix_statistics::product(self) }
        fn __b_mean(&self) -> T { matrix_statistics::mean(self) }
        fn __b_variance(&self) -> T { matrix_statistics::variance(self) }
        fn __b_row_product(&self) -> SMatrix<T, 1, C> { matrix_statistics::row_product(self) }
        fn __b_row_product_tr(&self) -> SVector<T, C> { matrix_statistics::row_product_tr(self) }
        fn __b_column_product(&self) -> SVector<T, R> { matrix_statistics::column_product(self) }
        fn __b_row_mean(&self) -> SMatrix<T, 1, C> { matrix_statistics::row_mean(self) }
        fn __b_row_mean_tr(&self) -> SVector<T, C> { matrix_statistics::row_mean_tr(self) }
        fn __b_column_mean(&self) -> SVector<T, R> { matrix_statistics::column_mean(self) }
        fn __b_row_variance(&self) -> SMatrix<T, 1, C> { matrix_statistics::row_variance(self) }
        fn __b_row_variance_tr(&self) -> SVector<T, C> { matrix_statistics::row_variance_tr(self) }
        fn __b_column_variance(&self) -> SVector<T, R> { matrix_statistics::column_variance(self) }

        fn __b_one_norm(&self) -> T { norms::one_norm(self) }
        fn __b_lp_norm(&self, p: i32) -> T { norms::lp_norm(self, p) }
        fn __b_metric_distance(&self, other: &Self) -> T { norms::metric_distance(self, other) }
        fn __b_normalize(&self) -> Self { norms::normalize(self) }
        fn __b_normalize_mut(&mut self) -> T { norms::normalize_mut(self) }
        fn __b_try_normalize(&self, least: T) -> Option<Self> { norms::try_normalize(self, least) }
        fn __b_try_normalize_mut(&mut self, least: T) -> Option<T> {
            norms::try_normalize_mut(self, least)
        }
        fn __b_set_magnitude(&mut self, magnitude: T) -> () { norms::set_magnitude(self, magnitude) }
        fn __b_try_set_magnitude(&mut self, magnitude: T, least: T) -> () {
            norms::try_set_magnitude(self, magnitude, least)
        }
        fn __b_cap_magnitude(&self, most: T) -> Self { norms::cap_magnitude(self, most) }
        fn __b_is_identity(&self, tolerance: T) -> bool { norms::is_identity(self, tolerance) }
        fn __b_is_orthogonal(&self, tolerance: T) -> bool { norms::is_orthogonal(self, tolerance) }

        fn __b_abs(&self) -> Self { elementwise::abs(self) }
        fn __b_add_scalar(&self, b: T) -> Self { elementwise::add_scalar(self, b) }
        fn __b_add_scalar_mut(&mut self, b: T) -> () { elementwise::add_scalar_mut(self, b) }
        fn __b_neg_mut(&mut self) -> () { elementwise::neg_mut(self) }
        fn __b_add_assign[B: (Borrow<Self>)](&mut self, other: B) -> () {
            elementwise::add_assign(self, other.borrow())
        }
        fn __b_sub_assign[B: (Borrow<Self>)](&mut self, other: B) -> () {
            elementwise::sub_assign(self, other.borrow())
        }
        fn __b_mul_assign(&mut self, factor: T) -> () { elementwise::scale_mut(self, factor) }
        fn __b_div_assign(&mut self, divisor: T) -> () { elementwise::unscale_mut(self, divisor) }
        fn __b_scale_mut(&mut self, factor: T) -> () { elementwise::scale_mut(self, factor) }
        fn __b_unscale_mut(&mut self, divisor: T) -> () { elementwise::unscale_mut(self, divisor) }
        fn __b_component_mul_assign(&mut self, b: &Self) -> () {
            elementwise::component_mul_assign(self, b)
        }
        fn __b_component_div_assign(&mut self, b: &Self) -> () {
            elementwise::component_div_assign(self, b)
        }
        fn __b_cmpy(&mut self, alpha: T, a: &Self, b: &Self, beta: T) -> () {
            elementwise::cmpy(self, alpha, a, b, beta)
        }
        fn __b_cdpy(&mut self, alpha: T, a: &Self, b: &Self, beta: T) -> () {
            elementwise::cdpy(self, alpha, a, b, beta)
        }

        fn __b_fill_with_identity(&mut self) -> () { matrix_edit::fill_with_identity(self) }

        fn __b_gemm<K>(&mut self, alpha: T, a: &SMatrix<T, R, K>, b: &SMatrix<T, K, C>, beta: T) -> () {
            blas::gemm(self, alpha, a, b, beta)
        }
        fn __b_gemm_tr<K>(
            &mut self, alpha: T, a: &SMatrix<T, K, R>, b: &SMatrix<T, K, C>, beta: T
        ) -> () {
            blas::gemm_tr(self, alpha, a, b, beta)
        }
        fn __b_gemm_ad<K>(
            &mut self, alpha: T, a: &SMatrix<T, K, R>, b: &SMatrix<T, K, C>, beta: T
        ) -> () {
            blas::gemm_tr(self, alpha, a, b, beta)
        }
        fn __b_ger(&mut self, alpha: T, x: &SVector<T, R>, y: &SVector<T, C>, beta: T) -> () {
            blas::ger(self, alpha, x, y, beta)
        }
        fn __b_gerc(&mut self, alpha: T, x: &SVector<T, R>, y: &SVector<T, C>, beta: T) -> () {
            blas::ger(self, alpha, x, y, beta)
        }
        fn __b_tr_dot(&self, b: &SMatrix<T, C, R>) -> T { blas::tr_dot(self, b) }
        fn __b_mul_to<K>(&self, b: &SMatrix<T, C, K>, out: &mut SMatrix<T, R, K>) -> () {
            blas::mul_to(self, b, out)
        }
        fn __b_tr_mul_to<K>(&self, b: &SMatrix<T, R, K>, out: &mut SMatrix<T, C, K>) -> () {
            blas::tr_mul_to(self, b, out)
        }
    }
}

companions! {
    /// Methods of matrices that need no arithmetic.
    ElementBuiltins<R, C>: Element [Self, T, R, C] for SMatrix<T, R, C>, [T, R, C] {
        fn __b_shape(&self) -> (usize, usize) { parts::shape(self) }
        fn __b_is_square(&self) -> bool { parts::is_square(self) }
        fn __b_fill(&mut self, value: T) -> () { matrix_edit::fill(self, value) }
        fn __b_fill_diagonal(&mut self, value: T) -> () { matrix_edit::fill_diagonal(self, value) }
        fn __b_fill_row(&mut self, row: usize, value: T) -> () { matrix_edit::fill_row(self, row, value) }
        fn __b_fill_column(&mut self, column: usize, value: T) -> () {
            matrix_edit::fill_column(self, column, value)
        }
        fn __b_fill_lower_triangle(&mut self, value: T, shift: usize) -> () {
            matrix_edit::fill_lower_triangle(self, value, shift)
        }
        fn __b_fill_upper_triangle(&mut self, value: T, shift: usize) -> () {
            matrix_edit::fill_upper_triangle(self, value, shift)
        }
        fn __b_swap(&mut self, one: (usize, usize), other: (usize, usize)) -> () {
            matrix_edit::swap(self, one, other)
        }
        fn __b_swap_rows(&mut self, one: usize, other: usize) -> () {
            matrix_edit::swap_rows(self, one, other)
        }
        fn __b_swap_columns(&mut self, one: usize, other: usize) -> () {
            matrix_edit::swap_columns(self, one, other)
        }
        fn __b_copy_from(&mut self, b: &Self) -> () { matrix_edit::copy_from(self, b) }
        fn __b_tr_copy_from(&mut self, b: &SMatrix<T, C, R>) -> () { matrix_edit::tr_copy_from(self, b) }
        fn __b_transpose_to(&self, b: &mut SMatrix<T, C, R>) -> () { matrix_edit::transpose_to(self, b) }
        fn __b_adjoint_to(&self, b: &mut SMatrix<T, C, R>) -> () { matrix_edit::transpose_to(self, b) }
        fn __b_lower_triangle(&self) -> Self { parts::lower_triangle(self) }
        fn __b_upper_triangle(&self) -> Self { parts::upper_triangle(self) }
        fn __b_from_diagonal_element(value: T) -> Self { parts::from_diagonal_element(value) }
        fn __b_from_columns(columns: &[SVector<T, R>; C]) -> Self { parts::from_columns(columns) }
        fn __b_from_rows(rows: &[SMatrix<T, 1, C>; R]) -> Self { parts::from_rows(rows) }
        fn __b_from_row_slice<N>(elements: &[T; N]) -> Self { parts::from_row_slice(elements) }
        fn __b_from_column_slice<N>(elements: &[T; N]) -> Self {
            parts::from_column_slice(elements)
        }
    }
}

companions! {
    /// Methods of square matrices that need no arithmetic.
    SquareElementBuiltins<N>: Element [Self, T, N] for SMatrix<T, N, N>, [T, N] {
        fn __b_diagonal(&self) -> SVector<T, N> { parts::diagonal(self) }
        fn __b_from_diagonal(diagonal: &SVector<T, N>) -> Self { parts::from_diagonal(diagonal) }
        fn __b_set_diagonal(&mut self, diagonal: &SVector<T, N>) -> () {
            matrix_edit::set_diagonal(self, diagonal)
        }
        fn __b_fill_lower_triangle_with_upper_triangle(&mut self) -> () {
            matrix_edit::fill_lower_triangle_with_upper_triangle(self)
        }
        fn __b_fill_upper_triangle_with_lower_triangle(&mut self) -> () {
            matrix_edit::fill_upper_triangle_with_lower_triangle(self)
        }
        fn __b_transpose_mut(&mut self) -> () { matrix_edit::transpose_mut(self) }
        fn __b_adjoint_mut(&mut self) -> () { matrix_edit::transpose_mut(self) }
    }
}

companions! {
    /// Methods of matrices of integers, too.
    NumberBuiltins<R, C>: Number [Self, T, R, C] for SMatrix<T, R, C>, [T, R, C] {
        fn __b_max(&self) -> T { matrix_extremes::max(self) }
        fn __b_min(&self) -> T { matrix_extremes::min(self) }
        fn __b_sum(&self) -> T { matrix_statistics::sum(self) }
        fn __b_row_sum(&self) -> SMatrix<T, 1, C> { matrix_statistics::row_sum(self) }
        fn __b_row_sum_tr(&self) -> SVector<T, C> { matrix_statistics::row_sum_tr(self) }
        fn __b_column_sum(&self) -> SVector<T, R> { matrix_statistics::column_sum(self) }
    }
}

companions! {
    /// Methods of square matrices of integers, too.
    SquareNumberBuiltins<N>: Number [Self, T, N] for SMatrix<T, N, N>, [T, N] {
        fn __b_trace(&self) -> T { parts::trace(self) }
    }
}

companions! {
    /// Methods of vectors.
    VectorPartBuiltins<N>: Real [Self, T, N] for SVector<T, N>, [T, N] {
        fn __b_argmax(&self) -> (usize, T) { matrix_extremes::argmax(self) }
        fn __b_argmin(&self) -> (usize, T) { matrix_extremes::argmin(self) }
        fn __b_imax(&self) -> usize { matrix_extremes::imax(self) }
        fn __b_imin(&self) -> usize { matrix_extremes::imin(self) }
        fn __b_iamax(&self) -> usize { matrix_extremes::iamax(self) }
        fn __b_icamax(&self) -> usize { matrix_extremes::iamax(self) }
        fn __b_iamin(&self) -> usize { matrix_extremes::iamin(self) }
        fn __b_lerp(&self, other: &Self, t: T) -> Self { elementwise::lerp(self, other, t) }
        fn __b_ith(place: usize, value: T) -> Self { parts::ith(place, value) }
        fn __b_gemv<K>(&mut self, alpha: T, a: &SMatrix<T, N, K>, x: &SVector<T, K>, beta: T) -> () {
            blas::gemv(self, alpha, a, x, beta)
        }
        fn __b_gemv_tr<K>(
            &mut self, alpha: T, a: &SMatrix<T, K, N>, x: &SVector<T, K>, beta: T
        ) -> () {
            blas::gemv_tr(self, alpha, a, x, beta)
        }
        fn __b_gemv_ad<K>(
            &mut self, alpha: T, a: &SMatrix<T, K, N>, x: &SVector<T, K>, beta: T
        ) -> () {
            blas::gemv_tr(self, alpha, a, x, beta)
        }
        fn __b_axpy(&mut self, alpha: T, x: &Self, beta: T) -> () { blas::axpy(self, alpha, x, beta) }
        fn __b_axcpy(&mut self, alpha: T, x: &Self, c: T, beta: T) -> () {
            blas::axcpy(self, alpha, x, c, beta)
        }
    }
}

companions! {
    /// Methods of square matrices.
    SquarePartBuiltins<N>: Real [Self, T, N] for SMatrix<T, N, N>, [T, N] {
        fn __b_try_inverse(self) -> Option<Self> { inverse(&self) }
        fn __b_is_invertible(&self) -> bool { norms::is_invertible(self) }
        fn __b_is_special_orthogonal(&self, tolerance: T) -> bool {
            norms::is_special_orthogonal(self, tolerance)
        }
        fn __b_pow(&self, exponent: u32) -> Self { matrix_powers::pow(self, exponent) }
        fn __b_pow_mut(&mut self, exponent: u32) -> () { matrix_powers::pow_mut(self, exponent) }
        fn __b_exp(&self) -> Self { matrix_powers::exp(self) }
        fn __b_symmetric_part(&self) -> Self { parts::symmetric_part(self) }
        fn __b_hermitian_part(&self) -> Self { parts::symmetric_part(self) }
        fn __b_syger(&mut self, alpha: T, x: &SVector<T, N>, y: &SVector<T, N>, beta: T) -> () {
            blas::syger(self, alpha, x, y, beta)
        }
        fn __b_hegerc(&mut self, alpha: T, x: &SVector<T, N>, y: &SVector<T, N>, beta: T) -> () {
            blas::syger(self, alpha, x, y, beta)
        }
        fn __b_quadform<K>(
            &mut self, alpha: T, mid: &SMatrix<T, K, K>, right: &SMatrix<T, K, N>, beta: T
        ) -> () {
            blas::quadform(self, alpha, mid, right, beta)
        }
        fn __b_quadform_tr<K>(
            &mut self, alpha: T, left: &SMatrix<T, N, K>, mid: &SMatrix<T, K, K>, beta: T
        ) -> () {
            blas::quadform_tr(self, alpha, left, mid, beta)
        }
    }
}

companions! {
    /// Methods of vectors of two.
    PerpBuiltin<>: Real [Self, T] for SVector<T, 2>, [T] {
        fn __b_perp(&self, other: &Self) -> T { blas::perp(self, other) }
    }
}

companions! {
    /// Matrices of one element.
    ScalarBuiltins<>: Element [Self, T] for SMatrix<T, 1, 1>, [T] {
        fn __b_to_scalar(&self) -> T { parts::to_scalar(self) }
        fn __b_into_scalar(self) -> T { parts::to_scalar(&self) }
    }
}

companions! {
    /// The same numbers in another type.
    CastBuiltin<R, C>: Real [Self, T, R, C] for SMatrix<T, R, C>, [T, R, C] {
        fn __b_cast[U: (Real)](self) -> SMatrix<U, R, C> { elementwise::cast(&self) }
    }
}

companions! {
    /// The matrix of the cross product.
    CrossMatrixBuiltin<>: Real [Self, T] for SVector<T, 3>, [T] {
        fn __b_cross_matrix(&self) -> SMatrix<T, 3, 3> { parts::cross_matrix(self) }
    }
}
