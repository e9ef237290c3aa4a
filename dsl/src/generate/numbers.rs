//! The companions of the methods of numbers, beyond those of [`builtin`](super::builtin).

use core::num::TryFromIntError;

use bessemer_ir::Intrinsic;
use bessemer_ir::tree::{self, ByteOrder, NumberMethod, Ty};

use super::builder::{Builder, Callee};
use super::builtin::{markers, signatures};
use super::slot::{Called, DslType, Seen};
use crate::math::integer;

markers! {
    WrappingAdd: Scalar(Intrinsic::WrappingAdd);
    WrappingSub: Scalar(Intrinsic::WrappingSub);
    WrappingMul: Scalar(Intrinsic::WrappingMul);
    WrappingDiv: Number(NumberMethod::WrappingDiv);
    WrappingRem: Number(NumberMethod::WrappingRem);
    SaturatingAdd: Scalar(Intrinsic::SaturatingAdd);
    SaturatingSub: Scalar(Intrinsic::SaturatingSub);
    SaturatingMul: Scalar(Intrinsic::SaturatingMul);
    WrappingNeg: Number(NumberMethod::WrappingNeg);
    SwapBytes: Number(NumberMethod::SwapBytes);
    WrappingShl: Number(NumberMethod::WrappingShl);
    WrappingShr: Number(NumberMethod::WrappingShr);
    RotateLeft: Number(NumberMethod::RotateLeft);
    RotateRight: Number(NumberMethod::RotateRight);
    CountOnes: Number(NumberMethod::CountOnes);
    CountZeros: Number(NumberMethod::CountZeros);
    LeadingZeros: Number(NumberMethod::LeadingZeros);
    LeadingOnes: Number(NumberMethod::LeadingOnes);
    TrailingZeros: Number(NumberMethod::TrailingZeros);
    TrailingOnes: Number(NumberMethod::TrailingOnes);
    AbsDiff: Number(NumberMethod::AbsDiff);
    IsPositive: Number(NumberMethod::IsPositive);
    IsNegative: Number(NumberMethod::IsNegative);
    WrappingAbs: Number(NumberMethod::WrappingAbs);
    UnsignedAbs: Scalar(Intrinsic::UnsignedAbs);
    IsPowerOfTwo: Number(NumberMethod::IsPowerOfTwo);
    Signum: Number(NumberMethod::Signum);
    DivEuclid: Number(NumberMethod::DivEuclid);
    RemEuclid: Number(NumberMethod::RemEuclid);
    Ceil: Scalar(Intrinsic::Ceil);
    Trunc: Scalar(Intrinsic::Trunc);
    Round: Scalar(Intrinsic::Round);
    Fract: Number(NumberMethod::Fract);
    Recip: Number(NumberMethod::Recip);
    ToDegrees: Number(NumberMethod::ToDegrees);
    ToRadians: Number(NumberMethod::ToRadians);
    IsNan: Scalar(Intrinsic::IsNan);
    IsFinite: Scalar(Intrinsic::IsFinite);
    IsInfinite: Scalar(Intrinsic::IsInfinite);
    IsSignNegative: Number(NumberMethod::IsSignNegative);
    IsSignPositive: Number(NumberMethod::IsSignPositive);
    ToLeBytes: Bytes(ByteOrder::Little);
    ToBeBytes: Bytes(ByteOrder::Big);
    FromLeBytes: Bytes(ByteOrder::Little);
    FromBeBytes: Bytes(ByteOrder::Big);
    From: Number(NumberMethod::From);
    TryFrom: TryFrom;
}

/// Methods of integers.
#[allow(missing_docs)]
pub trait IntegerBuiltins: Sized {
    type Unsigned;
    type Pow: Callee;
    type WrappingPow: Callee;
    signatures! {
        fn __b_wrapping_add(self, _other: Self) -> Called<WrappingAdd, Self>;
        fn __b_wrapping_sub(self, _other: Self) -> Called<WrappingSub, Self>;
        fn __b_wrapping_mul(self, _other: Self) -> Called<WrappingMul, Self>;
        fn __b_wrapping_div(self, _other: Self) -> Called<WrappingDiv, Self>;
        fn __b_wrapping_rem(self, _other: Self) -> Called<WrappingRem, Self>;
        fn __b_saturating_add(self, _other: Self) -> Called<SaturatingAdd, Self>;
        fn __b_saturating_sub(self, _other: Self) -> Called<SaturatingSub, Self>;
        fn __b_saturating_mul(self, _other: Self) -> Called<SaturatingMul, Self>;
        fn __b_wrapping_neg(self) -> Called<WrappingNeg, Self>;
        fn __b_swap_bytes(self) -> Called<SwapBytes, Self>;
        fn __b_wrapping_shl(self, _bits: u32) -> Called<WrappingShl, Self>;
        fn __b_wrapping_shr(self, _bits: u32) -> Called<WrappingShr, Self>;
        fn __b_rotate_left(self, _bits: u32) -> Called<RotateLeft, Self>;
        fn __b_rotate_right(self, _bits: u32) -> Called<RotateRight, Self>;
        fn __b_count_ones(self) -> Called<CountOnes, u32>;
        fn __b_count_zeros(self) -> Called<CountZeros, u32>;
        fn __b_leading_zeros(self) -> Called<LeadingZeros, u32>;
        fn __b_leading_ones(self) -> Called<LeadingOnes, u32>;
        fn __b_trailing_zeros(self) -> Called<TrailingZeros, u32>;
        fn __b_trailing_ones(self) -> Called<TrailingOnes, u32>;
        fn __b_abs_diff(self, _other: Self) -> Called<AbsDiff, Self::Unsigned>;
        fn __b_pow(self, _exponent: u32) -> Called<Self::Pow, Self>;
        fn __b_wrapping_pow(self, _exponent: u32) -> Called<Self::WrappingPow, Self>;
    }
}

/// Methods of signed integers.
#[allow(missing_docs)]
pub trait SignedBuiltins: IntegerBuiltins {
    signatures! {
        fn __b_is_positive(self) -> Called<IsPositive, bool>;
        fn __b_is_negative(self) -> Called<IsNegative, bool>;
        fn __b_wrapping_abs(self) -> Called<WrappingAbs, Self>;
        fn __b_unsigned_abs(self) -> Called<UnsignedAbs, Self::Unsigned>;
    }
}

/// Methods of unsigned integers.
#[allow(missing_docs)]
pub trait UnsignedBuiltins: Sized {
    fn __b_is_power_of_two(self) -> Called<IsPowerOfTwo, bool> {
        unreachable!()
    }
}

/// The sign as a number.
#[allow(missing_docs)]
pub trait SignBuiltins: Sized {
    fn __b_signum(self) -> Called<Signum, Self> {
        unreachable!()
    }
}

/// Division with a remainder of 0 or more.
#[allow(missing_docs)]
pub trait DivisionBuiltins: Sized {
    fn __b_div_euclid(self, _other: Self) -> Called<DivEuclid, Self> {
        unreachable!()
    }
    fn __b_rem_euclid(self, _other: Self) -> Called<RemEuclid, Self> {
        unreachable!()
    }
}

/// Methods of floats that are exact.
#[allow(missing_docs)]
pub trait FloatKindBuiltins: Sized {
    signatures! {
        fn __b_ceil(self) -> Called<Ceil, Self>;
        fn __b_trunc(self) -> Called<Trunc, Self>;
        fn __b_round(self) -> Called<Round, Self>;
        fn __b_fract(self) -> Called<Fract, Self>;
        fn __b_recip(self) -> Called<Recip, Self>;
        fn __b_to_degrees(self) -> Called<ToDegrees, Self>;
        fn __b_to_radians(self) -> Called<ToRadians, Self>;
        fn __b_is_nan(self) -> Called<IsNan, bool>;
        fn __b_is_finite(self) -> Called<IsFinite, bool>;
        fn __b_is_infinite(self) -> Called<IsInfinite, bool>;
        fn __b_is_sign_negative(self) -> Called<IsSignNegative, bool>;
        fn __b_is_sign_positive(self) -> Called<IsSignPositive, bool>;
    }
}

/// Numbers as bytes.
#[allow(missing_docs)]
pub trait BytesBuiltins: Sized {
    type Bytes;
    signatures! {
        fn __b_to_le_bytes(self) -> Called<ToLeBytes, Self::Bytes>;
        fn __b_to_be_bytes(self) -> Called<ToBeBytes, Self::Bytes>;
        fn __b_from_le_bytes(_bytes: Self::Bytes) -> Called<FromLeBytes, Self>;
        fn __b_from_be_bytes(_bytes: Self::Bytes) -> Called<FromBeBytes, Self>;
    }
}

/// Conversions that keep the value, and those of authors' own types.
#[allow(missing_docs)]
pub trait FromBuiltin<T>: Sized {
    /// Which function it is.
    type Marker;
    fn __b_from(_value: T) -> Called<Self::Marker, Self> {
        unreachable!()
    }
}

/// `x.into()`: the same, from the other end.
#[allow(missing_docs)]
pub trait IntoBuiltin<U: FromBuiltin<Self>>: Sized {
    fn __b_into(self) -> Called<U::Marker, U> {
        unreachable!()
    }
}

impl<T, U: FromBuiltin<T>> IntoBuiltin<U> for T {}

/// Conversions that may fail: of integers, and those of authors' own types.
#[allow(missing_docs)]
#[diagnostic::on_unimplemented(
    message = "no `try_from` of the DSL makes a `{Self}` of a `{T}`",
    label = "not a conversion of the DSL",
    note = "what always fits is `{Self}::from(x)`, and what is of that type is itself"
)]
pub trait TryFromBuiltin<T>: Sized {
    /// Which function it is.
    type Marker;
    /// Why there is no value.
    type Error;
    fn __b_try_from(_value: T) -> Called<Self::Marker, Result<Self, Self::Error>> {
        unreachable!()
    }
}

/// `x.try_into()`: the same, from the other end.
#[allow(missing_docs)]
pub trait TryIntoBuiltin<U: TryFromBuiltin<Self>>: Sized {
    fn __b_try_into(self) -> Called<U::Marker, Result<U, U::Error>> {
        unreachable!()
    }
}

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

/// That a number does not fit says nothing more: in the C it takes no room.
impl DslType for TryFromIntError {
    fn ty(_: &mut Builder) -> Ty {
        Ty::Unit
    }
}

impl Seen for TryFromIntError {
    type Slot = TryFromIntError;
}
