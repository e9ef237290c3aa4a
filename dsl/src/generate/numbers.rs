//! The companions of the methods of numbers, beyond those of [`builtin`](super::builtin).

use core::num::TryFromIntError;

use bessemer_ir::Intrinsic;
use bessemer_ir::tree::{self, ByteOrder, NumberMethod, Ty};

use super::builder::{Builder, Callee};
use super::builtin::{companions, markers};
use super::slot::{Called, DslType, Seen, dsl_types};
use crate::math::integer;
use crate::math::whole::WholeCompanions;

markers! {
    From: Number(NumberMethod::From);
    TryFrom: TryFrom;
}

companions! {
    /// Methods of integers.
    pub trait IntegerBuiltins: Sized {
        type Unsigned;
        type Pow: Callee;
        type WrappingPow: Callee;
        fn __b_wrapping_add(self, _other: Self) -> Self = WrappingAdd: Scalar(Intrinsic::WrappingAdd);
        fn __b_wrapping_sub(self, _other: Self) -> Self = WrappingSub: Scalar(Intrinsic::WrappingSub);
        fn __b_wrapping_mul(self, _other: Self) -> Self = WrappingMul: Scalar(Intrinsic::WrappingMul);
        fn __b_wrapping_div(self, _other: Self) -> Self = WrappingDiv: Number(NumberMethod::WrappingDiv);
        fn __b_wrapping_rem(self, _other: Self) -> Self = WrappingRem: Number(NumberMethod::WrappingRem);
        fn __b_saturating_add(self, _other: Self) -> Self = SaturatingAdd: Scalar(Intrinsic::SaturatingAdd);
        fn __b_saturating_sub(self, _other: Self) -> Self = SaturatingSub: Scalar(Intrinsic::SaturatingSub);
        fn __b_saturating_mul(self, _other: Self) -> Self = SaturatingMul: Scalar(Intrinsic::SaturatingMul);
        fn __b_wrapping_neg(self) -> Self = WrappingNeg: Number(NumberMethod::WrappingNeg);
        fn __b_swap_bytes(self) -> Self = SwapBytes: Number(NumberMethod::SwapBytes);
        fn __b_wrapping_shl(self, _bits: u32) -> Self = WrappingShl: Number(NumberMethod::WrappingShl);
        fn __b_wrapping_shr(self, _bits: u32) -> Self = WrappingShr: Number(NumberMethod::WrappingShr);
        fn __b_rotate_left(self, _bits: u32) -> Self = RotateLeft: Number(NumberMethod::RotateLeft);
        fn __b_rotate_right(self, _bits: u32) -> Self = RotateRight: Number(NumberMethod::RotateRight);
        fn __b_count_ones(self) -> u32 = CountOnes: Number(NumberMethod::CountOnes);
        fn __b_count_zeros(self) -> u32 = CountZeros: Number(NumberMethod::CountZeros);
        fn __b_leading_zeros(self) -> u32 = LeadingZeros: Number(NumberMethod::LeadingZeros);
        fn __b_leading_ones(self) -> u32 = LeadingOnes: Number(NumberMethod::LeadingOnes);
        fn __b_trailing_zeros(self) -> u32 = TrailingZeros: Number(NumberMethod::TrailingZeros);
        fn __b_trailing_ones(self) -> u32 = TrailingOnes: Number(NumberMethod::TrailingOnes);
        fn __b_abs_diff(self, _other: Self) -> Self::Unsigned = AbsDiff: Number(NumberMethod::AbsDiff);
        fn __b_pow(self, _exponent: u32) -> Self = [Self::Pow];
        fn __b_wrapping_pow(self, _exponent: u32) -> Self = [Self::WrappingPow];
    }
    /// Methods of signed integers.
    pub trait SignedBuiltins: IntegerBuiltins {
        fn __b_is_positive(self) -> bool = IsPositive: Number(NumberMethod::IsPositive);
        fn __b_is_negative(self) -> bool = IsNegative: Number(NumberMethod::IsNegative);
        fn __b_wrapping_abs(self) -> Self = WrappingAbs: Number(NumberMethod::WrappingAbs);
        fn __b_unsigned_abs(self) -> Self::Unsigned = UnsignedAbs: Scalar(Intrinsic::UnsignedAbs);
    }
    /// Methods of unsigned integers.
    pub trait UnsignedBuiltins: Sized {
        fn __b_is_power_of_two(self) -> bool = IsPowerOfTwo: Number(NumberMethod::IsPowerOfTwo);
    }
    /// The sign as a number.
    pub trait SignBuiltins: Sized {
        fn __b_signum(self) -> Self = Signum: Number(NumberMethod::Signum);
    }
    /// Division with a remainder of 0 or more.
    pub trait DivisionBuiltins: Sized {
        fn __b_div_euclid(self, _other: Self) -> Self = DivEuclid: Number(NumberMethod::DivEuclid);
        fn __b_rem_euclid(self, _other: Self) -> Self = RemEuclid: Number(NumberMethod::RemEuclid);
    }
    /// Methods of floats that are exact.
    pub trait FloatKindBuiltins: Sized {
        fn __b_ceil(self) -> Self = Ceil: Scalar(Intrinsic::Ceil);
        fn __b_trunc(self) -> Self = Trunc: Scalar(Intrinsic::Trunc);
        fn __b_round(self) -> Self = Round: Scalar(Intrinsic::Round);
        fn __b_fract(self) -> Self = Fract: Number(NumberMethod::Fract);
        fn __b_recip(self) -> Self = Recip: Number(NumberMethod::Recip);
        fn __b_to_degrees(self) -> Self = ToDegrees: Number(NumberMethod::ToDegrees);
        fn __b_to_radians(self) -> Self = ToRadians: Number(NumberMethod::ToRadians);
        fn __b_is_nan(self) -> bool = IsNan: Scalar(Intrinsic::IsNan);
        fn __b_is_finite(self) -> bool = IsFinite: Scalar(Intrinsic::IsFinite);
        fn __b_is_infinite(self) -> bool = IsInfinite: Scalar(Intrinsic::IsInfinite);
        fn __b_is_sign_negative(self) -> bool = IsSignNegative: Number(NumberMethod::IsSignNegative);
        fn __b_is_sign_positive(self) -> bool = IsSignPositive: Number(NumberMethod::IsSignPositive);
    }
    /// Numbers as bytes.
    pub trait BytesBuiltins: Sized {
        type Bytes;
        fn __b_to_le_bytes(self) -> Self::Bytes = ToLeBytes: Bytes(ByteOrder::Little);
        fn __b_to_be_bytes(self) -> Self::Bytes = ToBeBytes: Bytes(ByteOrder::Big);
        fn __b_from_le_bytes(_bytes: Self::Bytes) -> Self = FromLeBytes: Bytes(ByteOrder::Little);
        fn __b_from_be_bytes(_bytes: Self::Bytes) -> Self = FromBeBytes: Bytes(ByteOrder::Big);
    }
}

companions! {
    /// Conversions that keep the value, and those of authors' own types.
    pub trait FromBuiltin[T]: Sized {
        /// Which function it is.
        type Marker;
        fn __b_from(_value: T) -> Self = [Self::Marker];
    }
    /// `x.into()`: the same, from the other end.
    pub trait IntoBuiltin[U: FromBuiltin<Self>]: Sized {
        fn __b_into(self) -> U = [U::Marker];
    }
    /// Conversions that may fail: of integers, and those of authors' own types.
    #[diagnostic::on_unimplemented(
        message = "no `try_from` of the DSL makes a `{Self}` of a `{T}`",
        label = "not a conversion of the DSL",
        note = "what always fits is `{Self}::from(x)`, and what is of that type is itself"
    )]
    pub trait TryFromBuiltin[T]: Sized {
        /// Which function it is.
        type Marker;
        /// Why there is no value.
        type Error;
        fn __b_try_from(_value: T) -> Result<Self, Self::Error> = [Self::Marker];
    }
    /// `x.try_into()`: the same, from the other end.
    pub trait TryIntoBuiltin[U: TryFromBuiltin<Self>]: Sized {
        fn __b_try_into(self) -> Result<U, U::Error> = [U::Marker];
    }
}

impl<T, U: FromBuiltin<T>> IntoBuiltin<U> for T {}
impl<T, U: TryFromBuiltin<T>> TryIntoBuiltin<U> for T {}

macro_rules! integers {
    ($($int:ident, $unsigned:ident, $pow:ident, $wrapping_pow:ident;)*) => {$(
        impl IntegerBuiltins for $int {
            type Unsigned = $unsigned;
            type Pow = integer::$pow;
            type WrappingPow = integer::$wrapping_pow;
        }
        impl DivisionBuiltins for $int {}
    )*};
}

integers! {
    i8, u8, pow_i8, wrapping_pow_i8;
    i16, u16, pow_i16, wrapping_pow_i16;
    i32, u32, pow_i32, wrapping_pow_i32;
    i64, u64, pow_i64, wrapping_pow_i64;
    isize, usize, pow_isize, wrapping_pow_isize;
    u8, u8, pow_u8, wrapping_pow_u8;
    u16, u16, pow_u16, wrapping_pow_u16;
    u32, u32, pow_u32, wrapping_pow_u32;
    u64, u64, pow_u64, wrapping_pow_u64;
    usize, usize, pow_usize, wrapping_pow_usize;
}

macro_rules! implement {
    ($($name:ident: $($ty:ident)*;)*) => { $($(impl $name for $ty {})*)* };
}

implement! {
    WholeCompanions: i8 i16 i32 i64 isize u8 u16 u32 u64 usize;
    SignedBuiltins: i8 i16 i32 i64 isize;
    UnsignedBuiltins: u8 u16 u32 u64 usize;
    SignBuiltins: i8 i16 i32 i64 isize f32 f64;
    DivisionBuiltins: f32 f64;
    FloatKindBuiltins: f32 f64;
}

macro_rules! bytes {
    ($($count:literal: $($ty:ident)*;)*) => {$($(
        impl BytesBuiltins for $ty {
            type Bytes = [u8; $count];
        }
    )*)*};
}

bytes! {
    1: i8 u8;
    2: i16 u16;
    4: i32 u32 f32;
    8: i64 u64 isize usize f64;
}

macro_rules! conversions {
    ($($to:ident: $($from:ident)*;)*) => { $($(impl FromBuiltin<$from> for $to {
        type Marker = From;
    })*)* };
}

conversions! {
    i8: bool i8;
    i16: bool i8 i16 u8;
    i32: bool i8 i16 i32 u8 u16;
    i64: bool i8 i16 i32 i64 u8 u16 u32;
    isize: bool i8 i16 isize u8;
    u8: bool u8;
    u16: bool u8 u16;
    u32: bool u8 u16 u32;
    u64: bool u8 u16 u32 u64;
    usize: bool u8 u16 usize;
    f32: i8 i16 u8 u16 f32;
    f64: i8 i16 i32 u8 u16 u32 f32 f64;
}

/// Bytes as characters, and characters as their code points.
impl FromBuiltin<u8> for char {
    type Marker = From;
}

impl FromBuiltin<char> for u32 {
    type Marker = From;
}

macro_rules! narrowings {
    ($($to:ident: $($from:ident)*;)*) => { $($(impl TryFromBuiltin<$from> for $to {
        type Marker = TryFrom;
        type Error = TryFromIntError;
    })*)* };
}

narrowings! {
    i8: i16 i32 i64 isize u8 u16 u32 u64 usize;
    i16: i32 i64 isize u16 u32 u64 usize;
    i32: i64 isize u32 u64 usize;
    i64: isize u64 usize;
    isize: i32 i64 u16 u32 u64 usize;
    u8: i8 i16 i32 i64 isize u16 u32 u64 usize;
    u16: i8 i16 i32 i64 isize u32 u64 usize;
    u32: i8 i16 i32 i64 isize u64 usize;
    u64: i8 i16 i32 i64 isize usize;
    usize: i8 i16 i32 i64 isize u32 u64;
}

// That a number does not fit says nothing more: in the C it takes no room.
dsl_types! {
    [] [] TryFromIntError as Self => |_| Ty::Unit;
}
