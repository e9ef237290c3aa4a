//! The companions of the operations that the DSL knows: scalar methods and nalgebra's.
//!
//! One trait per kind of receiver, resolved by rustc as it resolves the method itself. The marker
//! names the operation; what it means is the typifier's business.

use bessemer_ir::tree::{self, MatrixMethod};
use bessemer_ir::{Intrinsic, Routine};
use nalgebra::{SMatrix, Scalar};

use super::builder::{Builder, Callee};
use super::slot::{Called, ScalarType, Value};

macro_rules! markers {
    ($($marker:ident: $kind:ident$(($operation:expr))?;)*) => {$(
        #[doc = concat!("The marker of `", stringify!($kind$(($operation))?), "`.")]
        pub struct $marker;
        impl Callee for $marker {
            fn callee(_: &mut Builder) -> tree::Callee {
                tree::Callee::Builtin(tree::Builtin::$kind$(($operation))?)
            }
        }
    )*};
}
pub(super) use markers;

/// Traits of companions, asked for their types alone: none is ever run. One is written as the `impl` of the type that has
/// the methods, or as a trait where that is not one type. What it is generic over stands in square brackets, and so does
/// what a method is generic over besides. Each companion has its marker: what that stands for is said where it is not
/// another's as well; a marker that is named by a path stands in square brackets.
macro_rules! companions {
    () => {};
    (
        $(#[$doc:meta])*
        impl[$($g:tt)*] $trait:ident $(<$($argument:ident),+>)? for [$element:ty] { $($companions:tt)* }
        $($more:tt)*
    ) => {
        $crate::generate::builtin::companions! { $(#[$doc])* pub trait $trait[$($g)*] { $($companions)* } $($more)* }
        impl<$($g)*> $trait $(<$($argument),+>)? for [$element] {}
    };
    (
        $(#[$doc:meta])*
        impl[$($g:tt)*] $trait:ident $(<$($argument:ident),+>)? for $of:ty
            $(where $place:ty: $bound:path)? { $($companions:tt)* }
        $($more:tt)*
    ) => {
        $crate::generate::builtin::companions! {
            $(#[$doc])*
            pub trait $trait[$($g)*]: Sized $(where $place: $bound)? { $($companions)* }
            $($more)*
        }
        impl<$($g)*> $trait $(<$($argument),+>)? for $of $(where $place: $bound)? {}
    };
    (
        $(#[$doc:meta])*
        pub trait $trait:ident $([$($g:tt)*])? $(: $($super:path),+)? $(where $place:ty: $limit:path)? {
            $($(#[$told:meta])* type $associated:ident $(: $kept:ident)?;)*
            $(
                fn $name:ident $([$($own:tt)*])? ($($parameters:tt)*) -> $result:ty
                    $(where $($of:ty: $bound:path),+)?
                    = $($marker:ident $(: $kind:ident$(($operation:expr))?)?)? $([$other:ty])?;
            )*
        }
        $($more:tt)*
    ) => {
        $($($($crate::generate::builtin::markers! { $marker: $kind$(($operation))?; })?)?)*

        $(#[$doc])*
        #[allow(missing_docs, clippy::type_complexity, clippy::too_many_arguments)]
        pub trait $trait $(<$($g)*>)? $(: $($super +)+)? $(where $place: $limit)? {
            $($(#[$told])* type $associated $(: $kept)?;)*
            $(
                fn $name $(<$($own)*>)? ($($parameters)*)
                    -> Called<$($marker)? $($other)?, $result>
                $(where $($of: $bound),+)?
                {
                    unreachable!("a witness copy is never run")
                }
            )*
        }

        $crate::generate::builtin::companions! { $($more)* }
    };
}
pub(super) use companions;

/// The companions of functions, asked for their types alone as well: what a function is generic over stands in square brackets.
macro_rules! calls {
    ($($($function:ident)::+ [$($g:tt)*] ($($parameters:tt)*) -> $result:ty = $marker:ty;)*) => {$(
        impl $($function)::+ {
            pub fn __call<$($g)*>($($parameters)*) -> Called<$marker, $result> {
                unreachable!("a witness copy is never run")
            }
        }
    )*};
}
pub(super) use calls;

markers! {
    New: Matrix(MatrixMethod::New);
    Real: Real;
}

companions! {
    /// Methods of floats.
    pub trait FloatBuiltins: Sized {
        type Bits: Value;
        fn __b_sqrt(self) -> Self = Sqrt: Scalar(Intrinsic::Sqrt);
        fn __b_floor(self) -> Self = Floor: Scalar(Intrinsic::Floor);
        fn __b_copysign(self, _sign: Self) -> Self = Copysign: Scalar(Intrinsic::Copysign);
        fn __b_to_bits(self) -> Self::Bits = ToBits: Scalar(Intrinsic::ToBits);
        fn __b_raw_bits(self) -> Self::Bits = RawBits: Scalar(Intrinsic::RawBits);
        fn __b_from_bits(_bits: Self::Bits) -> Self = FromBits: Scalar(Intrinsic::FromBits);
    }
    /// From a float to double precision.
    pub trait RealBuiltins: Sized {
        fn __b_as_f64(self) -> f64 = AsF64: AsF64;
    }
    /// Methods of numbers that are ordered.
    pub trait OrderBuiltins: Sized {
        fn __b_abs(self) -> Self = Abs: Scalar(Intrinsic::Abs);
        fn __b_min(self, _other: Self) -> Self = Min: Scalar(Intrinsic::Min);
        fn __b_max(self, _other: Self) -> Self = Max: Scalar(Intrinsic::Max);
        fn __b_clamp(self, _low: Self, _high: Self) -> Self = Clamp: Scalar(Intrinsic::Clamp);
    }
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
    }
    /// The identity of a matrix.
    impl[T: ScalarType + Scalar, const R: usize, const C: usize] IdentityBuiltin<T, R, C> for SMatrix<T, R, C> {
        fn __b_identity() -> Self = Identity: Matrix(MatrixMethod::Identity);
    }
    /// The unit vectors.
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
}

impl FloatBuiltins for f64 {
    type Bits = u64;
}

impl FloatBuiltins for f32 {
    type Bits = u32;
}

impl RealBuiltins for f64 {}
impl RealBuiltins for f32 {}

macro_rules! ordered {
    ($($ty:ty),*) => { $(impl OrderBuiltins for $ty {})* };
}
ordered!(f32, f64, i8, i16, i32, i64, isize, u8, u16, u32, u64, usize);

macro_rules! constructors {
    ($($name:ident($($argument:ident),*) for $(($rows:literal, $cols:literal)),*;)*) => {$(
        companions! {
            /// `new` with this many elements, by rows.
            pub trait $name[T]: Sized {
                fn __b_new($($argument: T),*) -> Self = [New];
            }
        }
        $(impl<T: ScalarType + Scalar> $name<T> for SMatrix<T, $rows, $cols> {})*
    )*};
}

constructors! {
    New1(_a) for (1, 1);
    New2(_a, _b) for (2, 1), (1, 2);
    New3(_a, _b, _c) for (3, 1), (1, 3);
    New4(_a, _b, _c, _d) for (4, 1), (1, 4), (2, 2);
    New5(_a, _b, _c, _d, _e) for (5, 1);
    New6(_a, _b, _c, _d, _e, _f) for (6, 1), (2, 3), (3, 2);
    New8(_a, _b, _c, _d, _e, _f, _g, _h) for (2, 4), (4, 2);
    New9(_a, _b, _c, _d, _e, _f, _g, _h, _i) for (3, 3);
    New12(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l) for (3, 4), (4, 3), (2, 6), (6, 2);
    New16(_a, _b, _c, _d, _e, _f, _g, _h, _i, _j, _k, _l, _m, _n, _o, _p) for (4, 4);
}
