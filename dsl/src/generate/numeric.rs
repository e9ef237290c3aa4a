//! The companions of the traits of `num_traits`, for code that is generic over numbers by bounds such as `T: Zero`.
//!
//! No prelude imports them: a bound on one of those traits implies one on the trait here, which the expansions of the
//! attributes write. A number of a known type keeps the companions of its own methods.

#![allow(missing_docs, non_camel_case_types)]

use core::cmp::Ordering;
use core::marker::PhantomData;

use alloc::format;
use alloc::string::String;
use bessemer_tree as tree;
use bessemer_tree::number::{Float, Int, Scalar};
use bessemer_tree::{MatrixMethod, NumberMethod, Site, Ty};

use super::builder::{Builder, Callee, OwnOperator, type_text};
use super::companions::{calls, companions};
use super::numbers::{self, IntegerBuiltins};
use super::slot::{Called, DslType};
use crate::comparison;
use crate::math::constants;

/// A function that each scalar has in an instance of its own.
pub struct OfScalar<T, F>(PhantomData<(T, F)>);

/// Instances of a function for floats and for integers.
pub trait Instances {
    type OfFloat<T: crate::math::Real>: Callee;
    type OfInteger<T: crate::math::Integer + IntegerBuiltins>: Callee;
    /// The operation for a matrix; none if matrices do not have the function.
    const OF_MATRIX: Option<MatrixMethod> = None;
    /// The name in Rust, for a type that does not have the function.
    const NAME: &'static str;
}

impl<T: DslType, F: Instances> Callee for OfScalar<T, F> {
    fn callee(cx: &mut Builder) -> tree::Callee {
        match T::ty(cx) {
            Ty::Scalar(Scalar::Float(Float::F32)) => F::OfFloat::<f32>::callee(cx),
            Ty::Scalar(Scalar::Float(Float::F64)) => F::OfFloat::<f64>::callee(cx),
            Ty::Scalar(Scalar::Int(Int::I8)) => F::OfInteger::<i8>::callee(cx),
            Ty::Scalar(Scalar::Int(Int::I16)) => F::OfInteger::<i16>::callee(cx),
            Ty::Scalar(Scalar::Int(Int::I32)) => F::OfInteger::<i32>::callee(cx),
            Ty::Scalar(Scalar::Int(Int::I64)) => F::OfInteger::<i64>::callee(cx),
            Ty::Scalar(Scalar::Int(Int::Isize)) => F::OfInteger::<isize>::callee(cx),
            Ty::Scalar(Scalar::Int(Int::U8)) => F::OfInteger::<u8>::callee(cx),
            Ty::Scalar(Scalar::Int(Int::U16)) => F::OfInteger::<u16>::callee(cx),
            Ty::Scalar(Scalar::Int(Int::U32)) => F::OfInteger::<u32>::callee(cx),
            Ty::Scalar(Scalar::Int(Int::U64)) => F::OfInteger::<u64>::callee(cx),
            Ty::Scalar(Scalar::Int(Int::Usize)) => F::OfInteger::<usize>::callee(cx),
            ty => match (&ty, F::OF_MATRIX) {
                (Ty::Matrix(..), Some(method)) => {
                    tree::Callee::Builtin(tree::Builtin::Matrix(method))
                }
                _ => cx.of_own_number(&ty, F::NAME),
            },
        }
    }
}

/// Declares functions, each with its name in Rust and its markers for floats and integers.
macro_rules! instances {
    ($($name:ident $rust:literal: $float:ty, $integer:ty $(, $matrix:ident)?;)*) => {$(
        #[doc = concat!("The instances of `", $rust, "`.")]
        pub struct $name;
        impl Instances for $name {
            type OfFloat<T: crate::math::Real> = $float;
            type OfInteger<T: crate::math::Integer + IntegerBuiltins> = $integer;
            $(const OF_MATRIX: Option<MatrixMethod> = Some(MatrixMethod::$matrix);)?
            const NAME: &'static str = $rust;
        }
    )*};
}

instances! {
    ZeroOf "zero": constants::__function_zero<T>, constants::__function_integer_zero<T>, Zeros;
    OneOf "one": constants::__function_one<T>, constants::__function_integer_one<T>, Identity;
    GreatestOf "max_value": constants::__function_max_value<T>, constants::__function_integer_max_value<T>;
    LeastOf "min_value": constants::__function_min_value<T>, constants::__function_integer_min_value<T>;
    IsZero "is_zero": constants::__function_is_zero<T>, constants::__function_integer_is_zero<T>;
    IsOne "is_one": constants::__function_is_one<T>, constants::__function_integer_is_one<T>;
    IsPositive "is_positive": numbers::IsSignPositive, numbers::IsPositive;
    IsNegative "is_negative": numbers::IsSignNegative, numbers::IsNegative;
    CheckedAdd "checked_add": NotOfFloats, T::CheckedAdd;
    CheckedSub "checked_sub": NotOfFloats, T::CheckedSub;
    CheckedMul "checked_mul": NotOfFloats, T::CheckedMul;
    CheckedDiv "checked_div": NotOfFloats, T::CheckedDiv;
    CheckedRem "checked_rem": NotOfFloats, T::CheckedRem;
    CheckedNeg "checked_neg": NotOfFloats, T::CheckedNeg;
    CheckedShl "checked_shl": NotOfFloats, T::CheckedShl;
    CheckedShr "checked_shr": NotOfFloats, T::CheckedShr;
    Pow "pow": NotOfFloats, T::Pow;
}

/// Marker of a function that floats do not have; rustc accepts no float for such a bound.
pub struct NotOfFloats;

impl Callee for NotOfFloats {
    fn callee(_: &mut Builder) -> tree::Callee {
        tree::Callee::Builtin(tree::Builtin::Number(NumberMethod::From))
    }
}

impl Builder {
    /// Returns the function of an author's type that implements a trait of `num_traits`; a type without a marked implementation is
    /// refused.
    fn of_own_number(&mut self, ty: &Ty, name: &'static str) -> tree::Callee {
        let scratch = &mut Builder::default();
        let mut all = inventory::iter::<OwnOperator>.into_iter();
        if let Some(own) = all.find(|own| own.name == name && (own.left)(scratch) == *ty) {
            return (own.build)(self);
        }
        let known = self.package.types.iter().find(|it| type_text(ty) == it.path);
        let (file, site) =
            known.map_or((String::new(), Site::default()), |it| (it.file.clone(), it.site));
        let of = type_text(ty);
        self.refuse(
            &file,
            site,
            format!("`{name}` of a trait of `num_traits` is not defined for `{of}` in the C"),
            "mark `impl Zero` and `impl One` of this type `#[data]`; for another trait declare one of your own with `#[interface]`, and implement it for numbers and for this type",
        );
        tree::Callee::Function(String::new())
    }
}

companions! {
    pub trait AnyZeroBuiltins: Sized {
        fn __b_zero() -> Self = [OfScalar<Self, ZeroOf>];
        fn __b_is_zero(&self) -> bool = [OfScalar<Self, IsZero>];
    }
    pub trait AnyOneBuiltins: Sized {
        fn __b_one() -> Self = [OfScalar<Self, OneOf>];
        fn __b_is_one(&self) -> bool = [OfScalar<Self, IsOne>];
    }
    pub trait AnyBoundedBuiltins: Sized {
        fn __b_max_value() -> Self = [OfScalar<Self, GreatestOf>];
        fn __b_min_value() -> Self = [OfScalar<Self, LeastOf>];
    }
    pub trait AnySignedBuiltins: Sized {
        fn __b_abs(&self) -> Self = [numbers::Abs];
        fn __b_signum(&self) -> Self = [numbers::Signum];
        fn __b_is_positive(&self) -> bool = [OfScalar<Self, IsPositive>];
        fn __b_is_negative(&self) -> bool = [OfScalar<Self, IsNegative>];
    }
    pub trait AnyNumCastBuiltins: Sized {
        fn __b_from[N: num_traits::ToPrimitive](_number: N) -> Option<Self> = [numbers::TryFrom];
    }
    pub trait AnyAsPrimitiveBuiltins[U]: Sized {
        fn __b_as_(self) -> U = [numbers::From];
    }
    pub trait AnyEuclidBuiltins: Sized {
        fn __b_div_euclid(&self, _other: &Self) -> Self = [numbers::DivEuclid];
        fn __b_rem_euclid(&self, _other: &Self) -> Self = [numbers::RemEuclid];
    }
    pub trait AnyToPrimitiveBuiltins: Sized {
        fn __b_to_i8(&self) -> Option<i8> = [numbers::TryFrom];
        fn __b_to_i16(&self) -> Option<i16> = [numbers::TryFrom];
        fn __b_to_i32(&self) -> Option<i32> = [numbers::TryFrom];
        fn __b_to_i64(&self) -> Option<i64> = [numbers::TryFrom];
        fn __b_to_isize(&self) -> Option<isize> = [numbers::TryFrom];
        fn __b_to_u8(&self) -> Option<u8> = [numbers::TryFrom];
        fn __b_to_u16(&self) -> Option<u16> = [numbers::TryFrom];
        fn __b_to_u32(&self) -> Option<u32> = [numbers::TryFrom];
        fn __b_to_u64(&self) -> Option<u64> = [numbers::TryFrom];
        fn __b_to_usize(&self) -> Option<usize> = [numbers::TryFrom];
        fn __b_to_f32(&self) -> Option<f32> = [numbers::TryFrom];
        fn __b_to_f64(&self) -> Option<f64> = [numbers::TryFrom];
    }
    pub trait AnyFromPrimitiveBuiltins: Sized {
        fn __b_from_i8(_number: i8) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_i16(_number: i16) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_i32(_number: i32) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_i64(_number: i64) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_isize(_number: isize) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_u8(_number: u8) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_u16(_number: u16) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_u32(_number: u32) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_u64(_number: u64) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_usize(_number: usize) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_f32(_number: f32) -> Option<Self> = [numbers::TryFrom];
        fn __b_from_f64(_number: f64) -> Option<Self> = [numbers::TryFrom];
    }
    pub trait AnyPrimIntBuiltins: Sized {
        fn __b_count_ones(self) -> u32 = [numbers::CountOnes];
        fn __b_count_zeros(self) -> u32 = [numbers::CountZeros];
        fn __b_leading_zeros(self) -> u32 = [numbers::LeadingZeros];
        fn __b_leading_ones(self) -> u32 = [numbers::LeadingOnes];
        fn __b_trailing_zeros(self) -> u32 = [numbers::TrailingZeros];
        fn __b_trailing_ones(self) -> u32 = [numbers::TrailingOnes];
        fn __b_rotate_left(self, _bits: u32) -> Self = [numbers::RotateLeft];
        fn __b_rotate_right(self, _bits: u32) -> Self = [numbers::RotateRight];
        fn __b_swap_bytes(self) -> Self = [numbers::SwapBytes];
        fn __b_pow(self, _exponent: u32) -> Self = [OfScalar<Self, Pow>];
        fn __b_min(self, _other: Self) -> Self = [numbers::Min];
        fn __b_max(self, _other: Self) -> Self = [numbers::Max];
        fn __b_clamp(self, _low: Self, _high: Self) -> Self = [numbers::Clamp];
        fn __b_signed_shl(self, _bits: u32) -> Self = ShiftLeft: Number(NumberMethod::ShiftLeft);
        fn __b_unsigned_shl(self, _bits: u32) -> Self = ShiftLeft;
        fn __b_signed_shr(self, _bits: u32) -> Self = SignedShr: Number(NumberMethod::SignedShr);
        fn __b_unsigned_shr(self, _bits: u32) -> Self = UnsignedShr: Number(NumberMethod::UnsignedShr);
        fn __b_to_le(self) -> Self = [numbers::From];
        fn __b_to_be(self) -> Self = [numbers::SwapBytes];
        fn __b_from_le(_word: Self) -> Self = [numbers::From];
        fn __b_from_be(_word: Self) -> Self = [numbers::SwapBytes];
    }
    pub trait AnyPartialOrdBuiltins: Sized {
        fn __b_partial_cmp(&self, _other: &Self) -> Option<Ordering> = [comparison::__function_partial<Self>];
    }
    pub trait AnyOrdBuiltins: Sized {
        fn __b_cmp(&self, _other: &Self) -> Ordering = [comparison::__function_compare<Self>];
    }
    pub trait AnySaturatingBuiltins: Sized {
        fn __b_saturating_add(self, _other: Self) -> Self = [numbers::SaturatingAdd];
        fn __b_saturating_sub(self, _other: Self) -> Self = [numbers::SaturatingSub];
    }
}

/// Writes the traits of one method each, with an operand by reference.
macro_rules! by_reference {
    ($($trait:ident $name:ident -> $result:ty = $marker:ty;)*) => {
        companions! {$(
            pub trait $trait: Sized {
                fn $name(&self, _other: &Self) -> $result = [$marker];
            }
        )*}
        $(impl<T> $trait for T {})*
    };
}

by_reference! {
    AnyWrappingAddBuiltins __b_wrapping_add -> Self = numbers::WrappingAdd;
    AnyWrappingSubBuiltins __b_wrapping_sub -> Self = numbers::WrappingSub;
    AnyWrappingMulBuiltins __b_wrapping_mul -> Self = numbers::WrappingMul;
    AnySaturatingAddBuiltins __b_saturating_add -> Self = numbers::SaturatingAdd;
    AnySaturatingSubBuiltins __b_saturating_sub -> Self = numbers::SaturatingSub;
    AnySaturatingMulBuiltins __b_saturating_mul -> Self = numbers::SaturatingMul;
    AnyCheckedAddBuiltins __b_checked_add -> Option<Self> = OfScalar<Self, CheckedAdd>;
    AnyCheckedSubBuiltins __b_checked_sub -> Option<Self> = OfScalar<Self, CheckedSub>;
    AnyCheckedMulBuiltins __b_checked_mul -> Option<Self> = OfScalar<Self, CheckedMul>;
    AnyCheckedDivBuiltins __b_checked_div -> Option<Self> = OfScalar<Self, CheckedDiv>;
    AnyCheckedRemBuiltins __b_checked_rem -> Option<Self> = OfScalar<Self, CheckedRem>;
}

companions! {
    pub trait AnyWrappingNegBuiltins: Sized {
        fn __b_wrapping_neg(&self) -> Self = [numbers::WrappingNeg];
    }
    pub trait AnyWrappingShlBuiltins: Sized {
        fn __b_wrapping_shl(&self, _bits: u32) -> Self = [numbers::WrappingShl];
    }
    pub trait AnyWrappingShrBuiltins: Sized {
        fn __b_wrapping_shr(&self, _bits: u32) -> Self = [numbers::WrappingShr];
    }
    pub trait AnyCheckedNegBuiltins: Sized {
        fn __b_checked_neg(&self) -> Option<Self> = [OfScalar<Self, CheckedNeg>];
    }
    pub trait AnyCheckedShlBuiltins: Sized {
        fn __b_checked_shl(&self, _bits: u32) -> Option<Self> = [OfScalar<Self, CheckedShl>];
    }
    pub trait AnyCheckedShrBuiltins: Sized {
        fn __b_checked_shr(&self, _bits: u32) -> Option<Self> = [OfScalar<Self, CheckedShr>];
    }
}

/// Defines the companions of `FloatConst`: the name of each constant, its companion, its marker and its function of the DSL.
macro_rules! constants_of_floats {
    ($($constant:literal $companion:ident $marker:ident $function:ident;)*) => {
        instances! {
            $($marker $constant: constants::$function<T>, NotOfFloats;)*
        }

        companions! {
            #[allow(non_snake_case)]
            pub trait AnyFloatConstBuiltins: Sized {
                $(fn $companion() -> Self = [OfScalar<Self, $marker>];)*
            }
        }
    };
}

constants_of_floats! {
    "E" __b_E EOf __function_euler;
    "FRAC_1_PI" __b_FRAC_1_PI Frac1PiOf __function_frac_1_pi;
    "FRAC_1_SQRT_2" __b_FRAC_1_SQRT_2 Frac1Sqrt2Of __function_frac_1_sqrt_2;
    "FRAC_2_PI" __b_FRAC_2_PI Frac2PiOf __function_frac_2_pi;
    "FRAC_2_SQRT_PI" __b_FRAC_2_SQRT_PI Frac2SqrtPiOf __function_frac_2_sqrt_pi;
    "FRAC_PI_2" __b_FRAC_PI_2 FracPi2Of __function_frac_pi_2;
    "FRAC_PI_3" __b_FRAC_PI_3 FracPi3Of __function_frac_pi_3;
    "FRAC_PI_4" __b_FRAC_PI_4 FracPi4Of __function_frac_pi_4;
    "FRAC_PI_6" __b_FRAC_PI_6 FracPi6Of __function_frac_pi_6;
    "FRAC_PI_8" __b_FRAC_PI_8 FracPi8Of __function_frac_pi_8;
    "LN_10" __b_LN_10 Ln10Of __function_ln_10;
    "LN_2" __b_LN_2 Ln2Of __function_ln_2;
    "LOG10_2" __b_LOG10_2 Log102Of __function_log10_2;
    "LOG10_E" __b_LOG10_E Log10EOf __function_log10_e;
    "LOG2_10" __b_LOG2_10 Log210Of __function_log2_10;
    "LOG2_E" __b_LOG2_E Log2EOf __function_log2_e;
    "PI" __b_PI PiOf __function_pi;
    "SQRT_2" __b_SQRT_2 Sqrt2Of __function_sqrt_2;
    "TAU" __b_TAU TauOf __function_two_pi;
}

/// Implements traits for all types: the bound that implies one says which have it.
macro_rules! for_all {
    ($($trait:ident)*) => { $(impl<T> $trait for T {})* };
}

for_all! {
    AnyZeroBuiltins AnyOneBuiltins AnyBoundedBuiltins AnySignedBuiltins AnyNumCastBuiltins AnyEuclidBuiltins
    AnyToPrimitiveBuiltins AnyFromPrimitiveBuiltins AnyPrimIntBuiltins AnySaturatingBuiltins AnyWrappingNegBuiltins
    AnyWrappingShlBuiltins AnyWrappingShrBuiltins AnyCheckedNegBuiltins AnyCheckedShlBuiltins AnyCheckedShrBuiltins
    AnyPartialOrdBuiltins AnyOrdBuiltins AnyFloatConstBuiltins
}

impl<T, U> AnyAsPrimitiveBuiltins<U> for T {}

/// Declares the types that replace the free functions of `num_traits`.
macro_rules! stand_for {
    ($($name:ident)*) => {$(
        #[doc = concat!("Replaces `num_traits::", stringify!($name), "`.")]
        pub struct $name;
    )*};
}

stand_for! { zero one cast abs signum }

calls! {
    zero[T]() -> T = [OfScalar<T, ZeroOf>];
    one[T]() -> T = [OfScalar<T, OneOf>];
    cast[T, U](_: T) -> Option<U> = [numbers::TryFrom];
    abs[T](_: T) -> T = [numbers::Abs];
    signum[T](_: T) -> T = [numbers::Signum];
}
