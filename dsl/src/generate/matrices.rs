//! Companions of matrices that the library does not write. They are operations, kernels, views, swizzles, conversions,
//! functions of several types as in nalgebra, and functions that change the size.

#![allow(missing_docs)]

use core::borrow::Borrow;
use core::marker::PhantomData;

use bessemer_tree as tree;
use bessemer_tree::operation::Routine;
use bessemer_tree::routine::KernelRoutine;
use bessemer_tree::{MatrixMethod, MatrixPart};
use nalgebra::allocator::Allocator;
use nalgebra::{
    Const, DefaultAllocator, DimAdd, DimDiff, DimMul, DimProd, DimSub, DimSum, OMatrix, SMatrix,
    SVector, Scalar, U1,
};

use super::builder::{Builder, Callee};
use super::companions::{calls, companions, markers};
use super::iterator::Items;
use super::numbers::{FromBuiltin, converts};
use super::slot::{Called, ScalarType, Value};
use crate::element::Element;
use crate::linear::{
    by_rows, elementwise, inverse_mut, kernels, lines, matrix_resize, parts, solve_into, solve_mut,
};
use crate::math::Real;

markers! {
    New: Matrix(MatrixMethod::New);
    FromArray: Matrix(MatrixMethod::FromArray);
}

calls! {
    by_rows[T: ScalarType + Scalar, const R: usize, const C: usize](_rows: [[T; C]; R]) -> SMatrix<T, R, C>
        = ByRows: Matrix(MatrixMethod::ByRows);
    solve_mut[T: ScalarType, const N: usize, const K: usize](_a: &mut SMatrix<T, N, N>, _b: &mut SMatrix<T, N, K>) -> bool
        = SolveMut: Kernel(KernelRoutine::LuSolve);
    solve_into[T: ScalarType, const N: usize, const K: usize](_a: &SMatrix<T, N, N>, _b: &mut SMatrix<T, N, K>) -> bool
        = SolveInto: Kernel(KernelRoutine::Solve);
    inverse_mut[T: ScalarType, const N: usize](_a: &mut SMatrix<T, N, N>) -> bool
        = InverseMut: Kernel(KernelRoutine::Inverse);
    kernels::cholesky_mut[T: ScalarType, const N: usize](_a: &mut SMatrix<T, N, N>) -> bool
        = CholeskyMut: Kernel(KernelRoutine::Cholesky);
    kernels::cholesky_lower[T: ScalarType + Scalar, const N: usize](_a: &SMatrix<T, N, N>) -> SMatrix<T, N, N>
        = CholeskyLower: Kernel(KernelRoutine::CholeskyLower);
    kernels::determinant[T: ScalarType, const N: usize](_a: &SMatrix<T, N, N>) -> T
        = Determinant: Kernel(KernelRoutine::Determinant);
}

/// Defines companions of solves with a factor.
macro_rules! solvers {
    ($($name:ident: $marker:ident -> $result:ty: $routine:expr;)*) => { calls! {$(
        kernels::$name[T: ScalarType, const N: usize, const K: usize](
            _a: &SMatrix<T, N, N>, _b: &mut SMatrix<T, N, K>
        ) -> $result = $marker: Kernel($routine);
    )*} };
}

solvers! {
    cholesky_solve_mut: CholeskySolveMut -> (): KernelRoutine::CholeskySolve;
    solve_lower_mut: SolveLowerMut -> bool: KernelRoutine::SolveLower;
    solve_upper_mut: SolveUpperMut -> bool: KernelRoutine::SolveUpper;
    tr_solve_lower_mut: TrSolveLowerMut -> bool: KernelRoutine::TrSolveLower;
    tr_solve_upper_mut: TrSolveUpperMut -> bool: KernelRoutine::TrSolveUpper;
}

companions! {
    pub mod traits[];
    /// Methods of matrices and vectors.
    impl[T: ScalarType + Scalar, const R: usize, const C: usize] MatrixBuiltins<T, R, C> for SMatrix<T, R, C> {
        fn __b_zeros() -> Self = Zeros: Matrix(MatrixMethod::Zeros);
        fn __b_from_element(_element: T) -> Self = FromElement: Matrix(MatrixMethod::FromElement);
        fn __b_repeat(_element: T) -> Self = FromElement;
        fn __b_nrows(&self) -> usize = Rows: Matrix(MatrixMethod::Rows);
        fn __b_ncols(&self) -> usize = Cols: Matrix(MatrixMethod::Cols);
        fn __b_len(&self) -> usize = Elements: Matrix(MatrixMethod::Elements);
        fn __b_transpose(&self) -> SMatrix<T, C, R> = Transpose: Linear(Routine::Transpose);
        fn __b_adjoint(&self) -> SMatrix<T, C, R> = Transpose;
        fn __b_scale(&self, _factor: T) -> Self = Scale: Linear(Routine::Scale);
        fn __b_unscale(&self, _divisor: T) -> Self = Unscale: Linear(Routine::Unscale);
        fn __b_tr_mul[const K: usize](&self, _other: &SMatrix<T, R, K>) -> SMatrix<T, C, K> = TrMul: Linear(Routine::TrMul);
        fn __b_ad_mul[const K: usize](&self, _other: &SMatrix<T, R, K>) -> SMatrix<T, C, K> = TrMul;
        fn __b_dot(&self, _other: &Self) -> T = Dot: Linear(Routine::Dot);
        fn __b_dotc(&self, _other: &Self) -> T = Dot;
        fn __b_norm(&self) -> T = Norm: Linear(Routine::Norm);
        fn __b_magnitude(&self) -> T = Norm;
        fn __b_norm_squared(&self) -> T = NormSquared: Linear(Routine::NormSquared);
        fn __b_magnitude_squared(&self) -> T = NormSquared;
        fn __b_component_mul(&self, _other: &Self) -> Self = ComponentMul: Linear(Routine::ComponentMul);
        fn __b_component_div(&self, _other: &Self) -> Self = ComponentDiv: Linear(Routine::ComponentDiv);
        fn __b_inf(&self, _other: &Self) -> Self = Inf: Linear(Routine::Inf);
        fn __b_sup(&self, _other: &Self) -> Self = Sup: Linear(Routine::Sup);
        fn __b_abs(&self) -> Self = Abs: Linear(Routine::Abs);
        fn __b_amax(&self) -> T = Amax: Linear(Routine::Amax);
        fn __b_camax(&self) -> T = Amax;
        fn __b_amin(&self) -> T = Amin: Linear(Routine::Amin);
        fn __b_camin(&self) -> T = Amin;
    }
    /// Constructor of the identity matrix.
    impl[T: ScalarType + Scalar, const R: usize, const C: usize] IdentityBuiltin<T, R, C> for SMatrix<T, R, C> {
        fn __b_identity() -> Self = Identity: Matrix(MatrixMethod::Identity);
    }
    /// Constructors of unit vectors.
    impl[T: ScalarType + Scalar, const N: usize] AxisBuiltins<T, N> for SMatrix<T, N, 1> {
        fn __b_x() -> Self = AxisX: Matrix(MatrixMethod::Axis(0));
        fn __b_y() -> Self = AxisY: Matrix(MatrixMethod::Axis(1));
        fn __b_z() -> Self = AxisZ: Matrix(MatrixMethod::Axis(2));
        fn __b_w() -> Self = AxisW: Matrix(MatrixMethod::Axis(3));
        fn __b_a() -> Self = AxisA: Matrix(MatrixMethod::Axis(4));
        fn __b_b() -> Self = AxisB: Matrix(MatrixMethod::Axis(5));
    }
    /// The cross product.
    impl[T: ScalarType + Scalar] CrossBuiltin<T> for SMatrix<T, 3, 1> {
        fn __b_cross(&self, _other: &Self) -> Self = Cross: Linear(Routine::Cross);
    }
    /// Methods of square matrices.
    impl[T: ScalarType + Scalar, const N: usize] SquareBuiltins<T, N> for SMatrix<T, N, N> {
        fn __b_determinant(&self) -> T = Determinant;
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
    /// Companion of `x.clone()` for a value with a derived `Clone`.
    pub trait CloneBuiltin: Clone, Value {
        fn __b_clone(&self) -> Self = Owned: Owned;
    }
    /// Companions of a view: a view that is read is already a copy.
    impl[T: Element, const R: usize, const C: usize] OwnedBuiltins<T, R, C> for SMatrix<T, R, C> {
        fn __b_into_owned(self) -> Self = Owned;
        fn __b_clone_owned(&self) -> Self = Owned;
    }
    /// Parts of matrices that are written. To rustc they are values of the part's type; the front end knows their
    /// places.
    impl[T: Element, const R: usize, const C: usize] WrittenViews<T, R, C> for SMatrix<T, R, C> {
        fn __b_row_mut(&mut self, _row: usize) -> SMatrix<T, 1, C> = RowsMut: Matrix(MatrixMethod::Part(MatrixPart::Rows));
        fn __b_column_mut(&mut self, _column: usize) -> SVector<T, R>
            = ColumnsMut: Matrix(MatrixMethod::Part(MatrixPart::Columns));
        fn __b_written_row(&mut self, _row: usize) -> SMatrix<T, 1, C> = RowsMut;
        fn __b_written_column(&mut self, _column: usize) -> SVector<T, R> = ColumnsMut;
        fn __b_fixed_rows_mut[const M: usize](&mut self, _row: usize) -> SMatrix<T, M, C> = RowsMut;
        fn __b_fixed_columns_mut[const N: usize](&mut self, _column: usize) -> SMatrix<T, R, N> = ColumnsMut;
        fn __b_fixed_view_mut[const M: usize, const N: usize](&mut self, _row: usize, _column: usize) -> SMatrix<T, M, N>
            = BlockMut: Matrix(MatrixMethod::Part(MatrixPart::Block));
    }
    /// Iterators over the lines of a matrix.
    impl[T: Element, const R: usize, const C: usize] LineBuiltins<T, R, C> for SMatrix<T, R, C> {
        fn __b_column_iter(&self) -> Items<SVector<T, R>> = [lines::__function_column_iter<T, R, C>];
        fn __b_row_iter(&self) -> Items<SMatrix<T, 1, C>> = [lines::__function_row_iter<T, R, C>];
        fn __b_column_iter_mut(&mut self) -> Items<SVector<T, R>> = [lines::__function_column_iter_mut<T, R, C>];
        fn __b_row_iter_mut(&mut self) -> Items<SMatrix<T, 1, C>> = [lines::__function_row_iter_mut<T, R, C>];
    }
    /// Methods of matrices whose result has another size.
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
    /// Companion of vectors with an additional element.
    impl[T: Real, const N: usize] PushBuiltin<T, N> for SVector<T, N> {
        fn __b_push(&self, _element: T) -> Larger<T, N, 1>
            where Const<N>: DimAdd<U1>, DefaultAllocator: Allocator<DimSum<Const<N>, U1>>
            = [Push<T, Larger<T, N, 1>, N>];
    }
}

impl<T: Clone + Value> CloneBuiltin for T {}

macro_rules! constructors {
    ($($name:ident($($argument:ident),*) for $(($rows:literal, $cols:literal)),*;)*) => {$(
        companions! {
            /// Companion of `new` with this many elements, by rows.
            pub trait $name[T]: Sized {
                fn __b_new($($argument: T),*) -> Self = [New];
            }
        }
        $(impl<T: ScalarType + Scalar> $name<T> for SMatrix<T, $rows, $cols> {})*
    )*};
}

constructors! {
    New1(_a) for (1, 1);
    New2(_a, _b) for (1, 2), (2, 1);
    New3(_a, _b, _c) for (1, 3), (3, 1);
    New4(_a, _b, _c, _d) for (1, 4), (2, 2), (4, 1);
    New5(_a, _b, _c, _d, _e) for (1, 5), (5, 1);
    New6(_a, _b, _c, _d, _e, _f) for (1, 6), (2, 3), (3, 2), (6, 1);
    New8(_a, _b, _c, _d, _e, _f, _g, _h) for (2, 4), (4, 2);
    New9(_a, _b, _c, _d, _e, _f, _g, _h, _i) for (3, 3);
    New10(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j) for (2, 5), (5, 2);
    New12(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l) for (2, 6), (3, 4), (4, 3), (6, 2);
    New15(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l, _m, _n, _o) for (3, 5), (5, 3);
    New16(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l, _m, _n, _o, _p) for (4, 4);
    New18(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l, _m, _n, _o, _p, _q, _r) for (3, 6), (6, 3);
    New20(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l, _m, _n, _o, _p, _q, _r, _s, _t) for (4, 5), (5, 4);
    New24(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l, _m, _n, _o, _p, _q, _r, _s, _t, _u, _v, _w, _x) for (4, 6), (6, 4);
    New25(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l, _m, _n, _o, _p, _q, _r, _s, _t, _u, _v, _w, _x, _y) for (5, 5);
    New30(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l, _m, _n, _o, _p, _q, _r, _s, _t, _u, _v, _w, _x, _y, _z, _aa, _ab, _ac, _ad) for (5, 6), (6, 5);
    New36(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l, _m, _n, _o, _p, _q, _r, _s, _t, _u, _v, _w, _x, _y, _z, _aa, _ab, _ac, _ad, _ae, _af, _ag, _ah, _ai, _aj) for (6, 6);
}

/// Defines companions of `Vector3::from([x, y, z])` and `Matrix2::from([[a, c], [b, d]])`, by columns, and of the
/// reverse conversions.
macro_rules! from_arrays {
    ($([$($n:ident),*] $matrix:ty: $array:ty;)*) => { converts! {$(
        [T: ScalarType + Scalar, $(const $n: usize),*] $array => $matrix: FromArray;
        [T: ScalarType + Scalar, $(const $n: usize),*] $matrix => $array: FromArray;
    )*} };
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
            /// Swizzles, vectors of a vector's components: `v.xy()`, `v.zyx()`.
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

/// Writes companions of methods whose result has another size. The type of the result selects the function, since the
/// size is a projection of nalgebra's.
macro_rules! resized {
    ($($(#[$doc:meta])* $marker:ident<$($n:ident),*> $method:ident => $function:ident<$($argument:ident),*>;)*) => {
        /// A matrix as a result whose size is known.
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
    /// Marker and size of `kronecker`.
    Kronecker<R, C, R2, C2> kronecker => __function_kronecker<R, C, R2, C2, ROWS, COLUMNS>;
    /// Marker and size of `push`.
    Push<N> push => __function_push<N, ROWS>;
    /// Marker and size of `insert_row`.
    InsertRow<R, C> insert_row => __function_insert_row<R, C, ROWS>;
    /// Marker and size of `insert_column`.
    InsertColumn<R, C> insert_column => __function_insert_column<R, C, COLUMNS>;
    /// Marker and size of `remove_row`.
    RemoveRow<R, C> remove_row => __function_remove_row<R, C, ROWS>;
    /// Marker and size of `remove_column`.
    RemoveColumn<R, C> remove_column => __function_remove_column<R, C, COLUMNS>;
}

type Product<T, const R: usize, const C: usize, const R2: usize, const C2: usize> =
    OMatrix<T, DimProd<Const<R>, Const<R2>>, DimProd<Const<C>, Const<C2>>>;
type Larger<T, const R: usize, const C: usize> = OMatrix<T, DimSum<Const<R>, U1>, Const<C>>;
type Wider<T, const R: usize, const C: usize> = OMatrix<T, Const<R>, DimSum<Const<C>, U1>>;
type Smaller<T, const R: usize, const C: usize> = OMatrix<T, DimDiff<Const<R>, U1>, Const<C>>;
type Narrower<T, const R: usize, const C: usize> = OMatrix<T, Const<R>, DimDiff<Const<C>, U1>>;
