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

/// Companions that are asked for their types alone: none is ever run. A method's own types stand in square brackets.
macro_rules! signatures {
    ($(
        $visible:vis fn $name:ident $([$($g:ident),*])? ($($parameters:tt)*) -> $result:ty
            $(where $of:ident: $bound:ident)?;
    )*) => {$(
        $visible fn $name $(<$($g),*>)? ($($parameters)*) -> $result $(where $of: $bound)? {
            unreachable!("a witness copy is never run")
        }
    )*};
}
pub(super) use signatures;

/// A trait of companions whose meaning is the typifier's business: each with its marker, and with what that stands for,
/// where it is not another's as well; a marker that is named by a path stands in square brackets, and so do a method's own
/// types.
macro_rules! operations {
    ($(
        $(#[$doc:meta])*
        pub trait $trait:ident $(<$($p:ident),*>)? $(: $super:ident)? {
            $(type $associated:ident $(: $kept:ident)?;)*
            $(
                fn $name:ident $([$($g:ident),*])? ($($parameters:tt)*) -> $result:ty
                    $(where $of:ident: $bound:ident)?
                    = $($marker:ident $(<$at:ident>)? $(: $kind:ident($operation:expr))?)? $([$other:ty])?;
            )*
        }
    )*) => {$(
        $($($(markers! { $marker: $kind($operation); })?)?)*

        $(#[$doc])*
        #[allow(missing_docs)]
        pub trait $trait $(<$($p),*>)? $(: $super)? {
            $(type $associated $(: $kept)?;)*
            $(
                fn $name $(<$($g),*>)? ($($parameters)*)
                    -> Called<$($marker $(<$at>)?)? $($other)?, $result>
                $(where $of: $bound)?
                {
                    unreachable!("a witness copy is never run")
                }
            )*
        }
    )*};
}
pub(super) use operations;

markers! {
    Sqrt: Scalar(Intrinsic::Sqrt); Floor: Scalar(Intrinsic::Floor); ToBits: Scalar(Intrinsic::ToBits); RawBits: Scalar(Intrinsic::RawBits); FromBits: Scalar(Intrinsic::FromBits); Copysign: Scalar(Intrinsic::Copysign);
    Abs: Scalar(Intrinsic::Abs); Min: Scalar(Intrinsic::Min); Max: Scalar(Intrinsic::Max); Clamp: Scalar(Intrinsic::Clamp);
    New: Matrix(MatrixMethod::New); Zeros: Matrix(MatrixMethod::Zeros); Identity: Matrix(MatrixMethod::Identity); FromElement: Matrix(MatrixMethod::FromElement);
    Transpose: Linear(Routine::Transpose); Dot: Linear(Routine::Dot); Cross: Linear(Routine::Cross); Norm: Linear(Routine::Norm); NormSquared: Linear(Routine::NormSquared);
    Real: Real; AsF64: AsF64;
    ComponentMul: Linear(Routine::ComponentMul); ComponentDiv: Linear(Routine::ComponentDiv); TrMul: Linear(Routine::TrMul);
    Scale: Linear(Routine::Scale); Unscale: Linear(Routine::Unscale);
    AxisX: Matrix(MatrixMethod::Axis(0)); AxisY: Matrix(MatrixMethod::Axis(1)); AxisZ: Matrix(MatrixMethod::Axis(2)); AxisW: Matrix(MatrixMethod::Axis(3)); AxisA: Matrix(MatrixMethod::Axis(4)); AxisB: Matrix(MatrixMethod::Axis(5));
    Rows: Matrix(MatrixMethod::Rows); Cols: Matrix(MatrixMethod::Cols); Elements: Matrix(MatrixMethod::Elements);
}

/// Methods of floats.
#[allow(missing_docs)]
pub trait FloatBuiltins: Sized {
    type Bits: Value;
    signatures! {
        fn __b_sqrt(self) -> Called<Sqrt, Self>;
        fn __b_floor(self) -> Called<Floor, Self>;
        fn __b_copysign(self, _sign: Self) -> Called<Copysign, Self>;
        fn __b_to_bits(self) -> Called<ToBits, Self::Bits>;
        fn __b_raw_bits(self) -> Called<RawBits, Self::Bits>;
        fn __b_from_bits(_bits: Self::Bits) -> Called<FromBits, Self>;
    }
}

impl FloatBuiltins for f64 {
    type Bits = u64;
}

impl FloatBuiltins for f32 {
    type Bits = u32;
}

/// From a float to double precision.
#[allow(missing_docs)]
pub trait RealBuiltins: Sized {
    fn __b_as_f64(self) -> Called<AsF64, f64> {
        unreachable!()
    }
}

impl RealBuiltins for f64 {}
impl RealBuiltins for f32 {}

/// Methods of numbers that are ordered.
#[allow(missing_docs)]
pub trait OrderBuiltins: Sized {
    signatures! {
        fn __b_abs(self) -> Called<Abs, Self>;
        fn __b_min(self, _other: Self) -> Called<Min, Self>;
        fn __b_max(self, _other: Self) -> Called<Max, Self>;
        fn __b_clamp(self, _low: Self, _high: Self) -> Called<Clamp, Self>;
    }
}

macro_rules! ordered {
    ($($ty:ty),*) => { $(impl OrderBuiltins for $ty {})* };
}
ordered!(f32, f64, i8, i16, i32, i64, isize, u8, u16, u32, u64, usize);

/// Methods of matrices and vectors.
#[allow(missing_docs)]
pub trait MatrixBuiltins<T, const R: usize, const C: usize>: Sized {
    signatures! {
        fn __b_zeros() -> Called<Zeros, Self>;
        fn __b_from_element(_element: T) -> Called<FromElement, Self>;
        fn __b_repeat(_element: T) -> Called<FromElement, Self>;
        fn __b_nrows(&self) -> Called<Rows, usize>;
        fn __b_ncols(&self) -> Called<Cols, usize>;
        fn __b_len(&self) -> Called<Elements, usize>;
        fn __b_transpose(&self) -> Called<Transpose, SMatrix<T, C, R>>;
        fn __b_adjoint(&self) -> Called<Transpose, SMatrix<T, C, R>>;
        fn __b_scale(&self, _factor: T) -> Called<Scale, Self>;
        fn __b_unscale(&self, _divisor: T) -> Called<Unscale, Self>;
    }
    fn __b_ad_mul<const K: usize>(
        &self,
        _other: &SMatrix<T, R, K>,
    ) -> Called<TrMul, SMatrix<T, C, K>> {
        unreachable!()
    }
    signatures! {
        fn __b_dot(&self, _other: &Self) -> Called<Dot, T>;
        fn __b_norm(&self) -> Called<Norm, T>;
        fn __b_norm_squared(&self) -> Called<NormSquared, T>;
        fn __b_magnitude(&self) -> Called<Norm, T>;
        fn __b_magnitude_squared(&self) -> Called<NormSquared, T>;
        fn __b_dotc(&self, _other: &Self) -> Called<Dot, T>;
        fn __b_component_mul(&self, _other: &Self) -> Called<ComponentMul, Self>;
        fn __b_component_div(&self, _other: &Self) -> Called<ComponentDiv, Self>;
    }
    fn __b_tr_mul<const K: usize>(
        &self,
        _other: &SMatrix<T, R, K>,
    ) -> Called<TrMul, SMatrix<T, C, K>> {
        unreachable!()
    }
}

impl<T: ScalarType + Scalar, const R: usize, const C: usize> MatrixBuiltins<T, R, C>
    for SMatrix<T, R, C>
{
}

/// The identity of a matrix.
pub trait IdentityBuiltin: Sized {
    #[allow(missing_docs)]
    fn __b_identity() -> Called<Identity, Self> {
        unreachable!()
    }
}

impl<T: ScalarType + Scalar, const R: usize, const C: usize> IdentityBuiltin for SMatrix<T, R, C> {}

macro_rules! axes {
    ($($name:ident $marker:ident;)*) => {
        /// The unit vectors.
        #[allow(missing_docs)]
        pub trait AxisBuiltins: Sized {$(
            fn $name() -> Called<$marker, Self> {
                unreachable!()
            }
        )*}
    };
}

axes! { __b_x AxisX; __b_y AxisY; __b_z AxisZ; __b_w AxisW; __b_a AxisA; __b_b AxisB; }

impl<T: ScalarType + Scalar, const N: usize> AxisBuiltins for SMatrix<T, N, 1> {}

/// The cross product.
pub trait CrossBuiltin: Sized {
    #[allow(missing_docs)]
    fn __b_cross(&self, _other: &Self) -> Called<Cross, Self> {
        unreachable!()
    }
}

impl<T: ScalarType + Scalar> CrossBuiltin for SMatrix<T, 3, 1> {}

macro_rules! constructors {
    ($($name:ident($($argument:ident),*) for $(($rows:literal, $cols:literal)),*;)*) => {$(
        /// `new` with this many elements, by rows.
        #[allow(missing_docs, clippy::too_many_arguments)]
        pub trait $name<T>: Sized {
            fn __b_new($($argument: T),*) -> Called<New, Self> {
                let _ = ($($argument,)*);
                unreachable!()
            }
        }
        $(impl<T: ScalarType + Scalar> $name<T> for SMatrix<T, $rows, $cols> {})*
    )*};
}

constructors! {
    New1(a) for (1, 1);
    New2(a, b) for (2, 1), (1, 2);
    New3(a, b, c) for (3, 1), (1, 3);
    New4(a, b, c, d) for (4, 1), (1, 4), (2, 2);
    New5(a, b, c, d, e) for (5, 1);
    New6(a, b, c, d, e, f) for (6, 1), (2, 3), (3, 2);
    New8(a, b, c, d, e, f, g, h) for (2, 4), (4, 2);
    New9(a, b, c, d, e, f, g, h, i) for (3, 3);
    New12(a, b, c, d, e, f, g, h, i, j, k, l) for (3, 4), (4, 3), (2, 6), (6, 2);
    New16(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p) for (4, 4);
}
