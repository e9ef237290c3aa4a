//! The companions of matrices that the library does not write: kernels, views, swizzles, what converts, and what takes more
//! than one type where nalgebra does.

#![allow(missing_docs)]

use core::borrow::Borrow;

use bessemer_ir::KernelRoutine;
use bessemer_ir::tree::{self, MatrixMethod, MatrixPart};
use nalgebra::{SMatrix, SVector, Scalar};

use super::builder::{Builder, Callee};
use super::builtin::{calls, companions, markers};
use super::iterator::Items;
use super::numbers::FromBuiltin;
use super::slot::{Called, ScalarType, Value};
use crate::element::Element;
use crate::linear::{
    by_rows, elementwise, inverse_mut, kernels, lines, parts, solve_into, solve_mut,
};
use crate::math::Real;

markers! {
    CholeskyMut: Kernel(KernelRoutine::Cholesky); CholeskyLower: Kernel(KernelRoutine::CholeskyLower); CholeskySolveMut: Kernel(KernelRoutine::CholeskySolve);
    SolveLowerMut: Kernel(KernelRoutine::SolveLower); SolveUpperMut: Kernel(KernelRoutine::SolveUpper);
    TrSolveLowerMut: Kernel(KernelRoutine::TrSolveLower); TrSolveUpperMut: Kernel(KernelRoutine::TrSolveUpper);
    ByRows: Matrix(MatrixMethod::ByRows); FromArray: Matrix(MatrixMethod::FromArray);
    SolveMut: Kernel(KernelRoutine::LuSolve); SolveInto: Kernel(KernelRoutine::Solve); InverseMut: Kernel(KernelRoutine::Inverse); Determinant: Kernel(KernelRoutine::Determinant);
    Owned: Owned;
    RowsMut: Matrix(MatrixMethod::Part(MatrixPart::Rows));
    ColumnsMut: Matrix(MatrixMethod::Part(MatrixPart::Columns));
    BlockMut: Matrix(MatrixMethod::Part(MatrixPart::Block));
}

calls! {
    by_rows[T: ScalarType + Scalar, const R: usize, const C: usize](_rows: [[T; C]; R]) -> SMatrix<T, R, C> = ByRows;
    solve_mut[T: ScalarType, const N: usize, const K: usize](_a: &mut SMatrix<T, N, N>, _b: &mut SMatrix<T, N, K>) -> bool
        = SolveMut;
    solve_into[T: ScalarType, const N: usize, const K: usize](_a: &SMatrix<T, N, N>, _b: &mut SMatrix<T, N, K>) -> bool
        = SolveInto;
    inverse_mut[T: ScalarType, const N: usize](_a: &mut SMatrix<T, N, N>) -> bool = InverseMut;
    kernels::cholesky_mut[T: ScalarType, const N: usize](_a: &mut SMatrix<T, N, N>) -> bool = CholeskyMut;
    kernels::cholesky_lower[T: ScalarType + Scalar, const N: usize](_a: &SMatrix<T, N, N>) -> SMatrix<T, N, N>
        = CholeskyLower;
    kernels::determinant[T: ScalarType, const N: usize](_a: &SMatrix<T, N, N>) -> T = Determinant;
}

/// Systems of equations with a factor.
macro_rules! solvers {
    ($($name:ident: $marker:ident -> $result:ty;)*) => { calls! {$(
        kernels::$name[T: ScalarType, const N: usize, const K: usize](
            _a: &SMatrix<T, N, N>, _b: &mut SMatrix<T, N, K>
        ) -> $result = $marker;
    )*} };
}

solvers! {
    cholesky_solve_mut: CholeskySolveMut -> ();
    solve_lower_mut: SolveLowerMut -> bool;
    solve_upper_mut: SolveUpperMut -> bool;
    tr_solve_lower_mut: TrSolveLowerMut -> bool;
    tr_solve_upper_mut: TrSolveUpperMut -> bool;
}

companions! {
    /// Methods of square matrices.
    impl[T: ScalarType + Scalar, const N: usize] SquareBuiltins<T, N> for SMatrix<T, N, N> {
        fn __b_determinant(&self) -> T = [Determinant];
    }
    /// Sums in place with a matrix, or with a reference to one.
    impl[T: Real, const R: usize, const C: usize] SumBuiltins<T, R, C> for SMatrix<T, R, C> {
        fn __b_add_assign[B: Borrow<Self>](&mut self, _other: B) -> () = [elementwise::__function_add_assign<T, R, C>];
        fn __b_sub_assign[B: Borrow<Self>](&mut self, _other: B) -> () = [elementwise::__function_sub_assign<T, R, C>];
    }
    /// Matrices of one element.
    impl[T: Element] ScalarBuiltins<T> for SMatrix<T, 1, 1> {
        fn __b_to_scalar(&self) -> T = [parts::__function_to_scalar<T>];
        fn __b_into_scalar(self) -> T = [parts::__function_to_scalar<T>];
    }
    /// `x.clone()` of what copies itself; of a reference it would be one.
    pub trait CopyBuiltin: Copy, Value {
        fn __b_clone(&self) -> Self = [Owned];
    }
    /// Of a view: what is read is a copy already.
    impl[T: Element, const R: usize, const C: usize] OwnedBuiltins<T, R, C> for SMatrix<T, R, C> {
        fn __b_into_owned(self) -> Self = [Owned];
        fn __b_clone_owned(&self) -> Self = [Owned];
    }
    /// Parts of matrices that are written: to rustc a value of the part's type, whose place the typifier knows.
    impl[T: Element, const R: usize, const C: usize] WrittenViews<T, R, C> for SMatrix<T, R, C> {
        fn __b_row_mut(&mut self, _row: usize) -> SMatrix<T, 1, C> = [RowsMut];
        fn __b_column_mut(&mut self, _column: usize) -> SVector<T, R> = [ColumnsMut];
        fn __b_written_row(&mut self, _row: usize) -> SMatrix<T, 1, C> = [RowsMut];
        fn __b_written_column(&mut self, _column: usize) -> SVector<T, R> = [ColumnsMut];
        fn __b_fixed_rows_mut[const M: usize](&mut self, _row: usize) -> SMatrix<T, M, C> = [RowsMut];
        fn __b_fixed_columns_mut[const N: usize](&mut self, _column: usize) -> SMatrix<T, R, N> = [ColumnsMut];
        fn __b_fixed_view_mut[const M: usize, const N: usize](&mut self, _row: usize, _column: usize) -> SMatrix<T, M, N>
            = [BlockMut];
    }
    /// The lines of a matrix, one after another.
    impl[T: Element, const R: usize, const C: usize] LineBuiltins<T, R, C> for SMatrix<T, R, C> {
        fn __b_column_iter(&self) -> Items<SVector<T, R>> = [lines::__function_column_iter<T, R, C>];
        fn __b_row_iter(&self) -> Items<SMatrix<T, 1, C>> = [lines::__function_row_iter<T, R, C>];
        fn __b_column_iter_mut(&mut self) -> Items<SVector<T, R>> = [lines::__function_column_iter_mut<T, R, C>];
        fn __b_row_iter_mut(&mut self) -> Items<SMatrix<T, 1, C>> = [lines::__function_row_iter_mut<T, R, C>];
    }
}

impl<T: Copy + Value> CopyBuiltin for T {}

/// `view.into()`: what is read is a copy already.
impl<T: Element, const R: usize, const C: usize> FromBuiltin<SMatrix<T, R, C>>
    for SMatrix<T, R, C>
{
    type Marker = Owned;
}

/// `Vector3::from([x, y, z])`, `Matrix2::from([[a, c], [b, d]])` by columns, and arrays of what they hold.
macro_rules! from_arrays {
    ($([$($n:ident),*] $matrix:ty: $array:ty;)*) => {$(
        impl<T: ScalarType + Scalar, $(const $n: usize),*> FromBuiltin<$array> for $matrix {
            type Marker = FromArray;
        }
        impl<T: ScalarType + Scalar, $(const $n: usize),*> FromBuiltin<$matrix> for $array {
            type Marker = FromArray;
        }
    )*};
}

from_arrays! {
    [N] SVector<T, N>: [T; N];
    [] SMatrix<T, 1, 2>: [T; 2];
    [] SMatrix<T, 1, 3>: [T; 3];
    [] SMatrix<T, 1, 4>: [T; 4];
    [] SMatrix<T, 1, 5>: [T; 5];
    [] SMatrix<T, 1, 6>: [T; 6];
    [R, C] SMatrix<T, R, C>: [[T; R]; C];
}

macro_rules! swizzles {
    ($($count:literal { $($method:ident $marker:ident $axes:expr;)* })*) => {
        companions! {
            /// Vectors of a vector's components: `v.xy()`, `v.zyx()`.
            impl[T: Element, const N: usize] SwizzleBuiltins<T, N> for SVector<T, N> {$($(
                fn $method(&self) -> SVector<T, $count> = $marker: Matrix(MatrixMethod::Swizzle($axes, $count));
            )*)*}
        }
    };
}

swizzles! {
    2 {
        __b_xx Xx [0, 0, 0]; __b_xy Xy [0, 1, 0]; __b_xz Xz [0, 2, 0];
        __b_yx Yx [1, 0, 0]; __b_yy Yy [1, 1, 0]; __b_yz Yz [1, 2, 0];
        __b_zx Zx [2, 0, 0]; __b_zy Zy [2, 1, 0]; __b_zz Zz [2, 2, 0];
    }
    3 {
        __b_xxx Xxx [0, 0, 0]; __b_xxy Xxy [0, 0, 1]; __b_xxz Xxz [0, 0, 2];
        __b_xyx Xyx [0, 1, 0]; __b_xyy Xyy [0, 1, 1]; __b_xyz Xyz [0, 1, 2];
        __b_xzx Xzx [0, 2, 0]; __b_xzy Xzy [0, 2, 1]; __b_xzz Xzz [0, 2, 2];
        __b_yxx Yxx [1, 0, 0]; __b_yxy Yxy [1, 0, 1]; __b_yxz Yxz [1, 0, 2];
        __b_yyx Yyx [1, 1, 0]; __b_yyy Yyy [1, 1, 1]; __b_yyz Yyz [1, 1, 2];
        __b_yzx Yzx [1, 2, 0]; __b_yzy Yzy [1, 2, 1]; __b_yzz Yzz [1, 2, 2];
        __b_zxx Zxx [2, 0, 0]; __b_zxy Zxy [2, 0, 1]; __b_zxz Zxz [2, 0, 2];
        __b_zyx Zyx [2, 1, 0]; __b_zyy Zyy [2, 1, 1]; __b_zyz Zyz [2, 1, 2];
        __b_zzx Zzx [2, 2, 0]; __b_zzy Zzy [2, 2, 1]; __b_zzz Zzz [2, 2, 2];
    }
}
